// fake_series.h: a data set of made-up times that counts what is read of it, for the session.
#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/session/session.h"

/// What all data sets of one test share.
struct FakeSeries {
    std::atomic<int> times = 6;
    std::atomic<int> failing = -1;  ///< a time that cannot be read
    std::atomic<int> slowMs = 0;    ///< that a read of cloud takes at least
    neph::MapGrid map{};            ///< where the grid lies
    std::optional<neph::UtcTime> firstUtc{};
    glm::dvec2 movesM{0.0};  ///< of the grid over the ground, from time to time
    std::mutex mutex;
    std::map<int, int> cloudReads;  ///< time to number of reads of its cloud

    int readsOf(int time) {
        const std::lock_guard lock(mutex);
        return cloudReads[time];
    }
};

/// 8 x 8 columns of 1 km, 4 layers of 500 m; a cloud in columns 2 to 4 of the lowest layer.
class FakeDataset : public neph::Dataset {
  public:
    FakeDataset(std::shared_ptr<FakeSeries> series, const std::filesystem::path& file)
        : series_(std::move(series)) {
        using neph::VariableRole;
        info_.model = "Fake";
        info_.size = {8, 8, 4};
        info_.spacingM = {1000.0, 1000.0};
        for (int t = 0; t < series_->times; ++t) {
            info_.times.push_back({"time " + std::to_string(t), 600.0 * t, file, t});
            info_.times.back().gridOffsetM = static_cast<double>(t) * series_->movesM;
            if (!series_->firstUtc) continue;
            info_.times.back().utc = *series_->firstUtc + std::chrono::seconds(600 * t);
        }
        info_.map = series_->map;
        add("z", VariableRole::interfaceHeight, {}, {8, 8, 5});
        add("rho", VariableRole::dryAirDensity, {}, {8, 8, 4});
        add("qc", VariableRole::mixingRatio, neph::Species::cloud, {8, 8, 4});
    }

    neph::Array3f read(std::string_view variable, int time, std::optional<neph::CellBox> box,
                       const neph::Progress& progress) override {
        const neph::VariableInfo& known = *info_.find(variable);
        const neph::CellBox part = box.value_or(neph::CellBox{glm::ivec3(0), known.size});
        if (variable == "qc") count(time, part, progress);
        neph::Array3f field(part.size());
        for (int z = 0; z < field.size.z; ++z) {
            for (int y = 0; y < field.size.y; ++y) {
                for (int x = 0; x < field.size.x; ++x) {
                    field.at(x, y, z) = valueAt(variable, part.lower + glm::ivec3(x, y, z));
                }
            }
        }
        return field;
    }

  private:
    static float valueAt(std::string_view variable, glm::ivec3 cell) {
        if (variable == "z") return 500.0f * static_cast<float>(cell.z);
        if (variable == "rho") return 1.0f;
        return cell.x >= 2 && cell.x <= 4 && cell.z == 0 ? 1e-3f : 0.0f;
    }

    void count(int time, const neph::CellBox& part, const neph::Progress& progress) {
        if (time == series_->failing) throw neph::Error({"fake", "is half written", "", "", ""});
        const auto until =
            std::chrono::steady_clock::now() + std::chrono::milliseconds(series_->slowMs);
        while (std::chrono::steady_clock::now() < until) {
            if (!neph::goOn(progress, 0.5)) throw neph::Cancelled{};
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (part.lower.y != 0) return;  // once a time, whatever bands it is read in
        const std::lock_guard lock(series_->mutex);
        ++series_->cloudReads[time];
    }

    void add(const std::string& name, neph::VariableRole role, std::optional<neph::Species> species,
             glm::ivec3 size) {
        neph::VariableInfo variable;
        variable.name = name;
        variable.role = role;
        variable.species = species;
        variable.size = size;
        info_.variables.push_back(variable);
    }

    std::shared_ptr<FakeSeries> series_;
};

/// Opens whatever is named as `series`.
inline neph::OpenSeries openFake(const std::shared_ptr<FakeSeries>& series) {
    return [series](std::span<const std::filesystem::path> paths, const neph::Progress&) {
        return std::make_shared<FakeDataset>(series, paths.front());
    };
}

/// Lets a session load; whether a volume is there within some ten seconds.
inline bool waitUntilShown(neph::Session& session) {
    for (int i = 0; i < 10000 && session.shown() == nullptr; ++i) {
        session.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return session.shown() != nullptr;
}
