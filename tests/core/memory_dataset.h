// memory_dataset.h: a data set in memory for tests: heights, density, and species by function.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/dataset/dataset.h"

/// A dataset in memory: heights, unit or given density, and species by function.
class MemoryDataset : public neph::Dataset {
  public:
    MemoryDataset(glm::ivec3 size, const std::function<float(int x, int y, int z)>& height) {
        info_.size = size;
        info_.spacingM = {500.0, 250.0};
        info_.times = {{"2024-05-06_21:00:00", 0.0, "memory", 0}};
        add("z", neph::VariableRole::interfaceHeight, {}, size + glm::ivec3(0, 0, 1), height);
        // As air has it at the height of each cell.
        add("rho", neph::VariableRole::dryAirDensity, {}, size, [&height](int x, int y, int z) {
            const float middle = 0.5f * (height(x, y, z) + height(x, y, z + 1));
            return 1.2f * std::exp(-std::max(middle, 0.0f) / 7200.0f);
        });
    }

    void addRatio(neph::Species species, const std::function<float(int, int, int)>& value) {
        add("Q_" + std::string(neph::info(species).id), neph::VariableRole::mixingRatio, species,
            info_.size, value);
    }

    /// Cells of these faces, metres; spacingM is the smallest width.
    void stretch(const std::vector<double>& xM, const std::vector<double>& yM) {
        info_.edgesM = {xM, yM};
        for (int axis = 0; axis < 2; ++axis) {
            const std::vector<double>& edges = axis == 0 ? xM : yM;
            double least = edges.back();
            for (std::size_t i = 1; i < edges.size(); ++i) {
                least = std::min(least, edges[i] - edges[i - 1]);
            }
            info_.spacingM[axis] = least;
        }
    }

    /// A later time, in a file of its own, with the same values but without some variables.
    void addTime(const std::string& label, const std::string& file,
                 std::set<std::string> lacking = {}) {
        info_.times.push_back({label, 600.0 * static_cast<double>(info_.times.size()), file, 0});
        lacking_[static_cast<int>(info_.times.size()) - 1] = std::move(lacking);
    }
    bool has(std::string_view variable, int time) const override {
        const auto lacking = lacking_.find(time);
        return info_.find(variable) != nullptr &&
               (lacking == lacking_.end() || !lacking->second.contains(std::string(variable)));
    }
    /// How often a variable was read from this handle.
    int reads(const std::string& variable) const {
        const auto found = reads_.find(variable);
        return found == reads_.end() ? 0 : found->second;
    }
    /// For what a reader states besides the fields.
    neph::DatasetInfo& stated() { return info_; }

    neph::Array3f read(std::string_view variable, int time, std::optional<neph::CellBox> box,
                       const neph::Progress&) override {
        if (!has(variable, time)) throw neph::Error({.what = "it is not there"});
        ++reads_[std::string(variable)];
        const neph::Array3f& field = fields_.at(std::string(variable));
        if (!box) return field;
        neph::Array3f part(box->size());
        for (int z = 0; z < part.size.z; ++z) {
            for (int y = 0; y < part.size.y; ++y) {
                for (int x = 0; x < part.size.x; ++x) {
                    const glm::ivec3 cell = box->lower + glm::ivec3(x, y, z);
                    part.at(x, y, z) = field.at(cell.x, cell.y, cell.z);
                }
            }
        }
        return part;
    }
    std::unique_ptr<neph::Dataset> anotherHandle() const override {
        auto other = std::unique_ptr<MemoryDataset>(new MemoryDataset);
        other->info_ = info_;
        other->fields_ = fields_;
        other->lacking_ = lacking_;
        return other;
    }

    /// The same with heights and density as they are in the south-west column, 1 x 1 x n.
    MemoryDataset withProfiles() const {
        MemoryDataset flat;
        flat.info_ = info_;
        flat.info_.variables.clear();
        for (const auto& variable : info_.variables) {
            const neph::Array3f& field = fields_.at(variable.name);
            flat.add(variable.name, variable.role, variable.species, {1, 1, field.size.z},
                     [&](int, int, int z) { return field.at(0, 0, z); });
        }
        return flat;
    }

    void add(const std::string& name, neph::VariableRole role, std::optional<neph::Species> species,
             glm::ivec3 size, const std::function<float(int, int, int)>& value) {
        neph::VariableInfo variable;
        variable.name = name;
        variable.role = role;
        variable.species = species;
        variable.size = size;
        info_.variables.push_back(variable);
        neph::Array3f field(size);
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) field.at(x, y, z) = value(x, y, z);
            }
        }
        fields_[name] = std::move(field);
    }

  private:
    MemoryDataset() = default;

    std::map<std::string, neph::Array3f> fields_;
    std::map<int, std::set<std::string>> lacking_;
    std::map<std::string, int> reads_;  ///< of this handle
};
