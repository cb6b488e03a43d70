// cm1.cpp: the times of a run of CM1 that writes GrADS binary.
#include "readers/raw_les/cm1.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "readers/raw_les/grads_ctl.h"
#include "readers/raw_les/raw_values.h"

namespace les {
namespace {

/// Every `step`th number from `first` on; nothing unless they increase, as CM1 writes them, and are
/// sizes of times.
std::optional<std::vector<double>> secondsIn(const std::vector<double>& numbers, std::size_t first,
                                             std::size_t step) {
    std::vector<double> seconds;
    for (std::size_t i = first; i < numbers.size(); i += step) {
        const double size = std::abs(numbers[i]);
        const bool possible = size == 0.0 || (size > 1e-6 && size < 1e12);
        if (!possible || (!seconds.empty() && numbers[i] <= seconds.back())) return {};
        seconds.push_back(numbers[i]);
    }
    return seconds;
}

/// Where a variable stands in each record: after the planes of those that are listed before it.
std::uint64_t placeOf(const Ctl& ctl, std::string_view name) {
    std::uint64_t before = 0;
    for (const CtlVariable& variable : ctl.variables) {
        if (variable.name == name) break;
        before += variable.planes();
    }
    return before;
}

/// domainlocx and domainlocy of every record; nothing unless both are there and lengths.
std::array<std::vector<double>, 2> offsetsIn(const Ctl& ctl, const std::vector<double>& numbers) {
    constexpr double kMostM = 1e8;  // farther than around the Earth
    std::array<std::vector<double>, 2> offsets;
    const std::array<std::string_view, 2> names{"domainlocx", "domainlocy"};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::uint64_t place = placeOf(ctl, names[axis]);
        if (place == ctl.planes()) return {};
        for (std::size_t i = place; i < numbers.size(); i += ctl.planes()) {
            if (!(std::abs(numbers[i]) <= kMostM)) return {};
            offsets[axis].push_back(numbers[i]);
        }
    }
    return offsets;
}

}  // namespace

std::vector<std::array<double, 2>> cm1Offsets(const Cm1Times& times, const Cm1Run& run) {
    std::vector<std::array<double, 2>> offsets(times.seconds.size());
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::vector<double>& stated = times.offsetM[axis];
            offsets[i][axis] = stated.empty() ? run.speedMPerS[axis] * times.seconds[i] : stated[i];
        }
    }
    return offsets;
}

std::optional<Cm1Times> cm1Times(const std::string& folder, bool swapped) {
    constexpr std::size_t kMaxTimes = 1'000'000;
    const auto text = findText((std::filesystem::path(folder) / "cm1out_metadata.ctl").string());
    if (!text) return {};
    Ctl ctl;
    try {
        ctl = parseCtl(*text);
    } catch (const Error&) {
        return {};
    }
    const auto mtime = std::ranges::find(ctl.variables, "mtime", &CtlVariable::name);
    const std::uint64_t record = ctl.planes();
    const std::string name = ctl.dset.starts_with('^') ? ctl.dset.substr(1) : ctl.dset;
    const std::string data = (std::filesystem::path(folder) / name).string();
    const auto bytes = fileSize(data);
    if (mtime == ctl.variables.end() || ctl.x.count != 1 || ctl.y.count != 1 || !bytes ||
        ctl.t.count > kMaxTimes || record * ctl.t.count * 4 > *bytes) {
        return {};
    }
    const std::uint64_t first = placeOf(ctl, "mtime");
    const bool stated = ctl.byteOrder != ByteOrder::unstated;
    if (stated) swapped = isSwapped(ctl.byteOrder);
    for (const bool order : {swapped, !swapped}) {
        const auto numbers = readNumbers(data, NumberType::float32, order, record * ctl.t.count);
        if (auto seconds = secondsIn(numbers, first, record)) {
            return Cm1Times{std::move(*seconds), offsetsIn(ctl, numbers)};
        }
        if (stated) break;
    }
    return {};
}

}  // namespace les
