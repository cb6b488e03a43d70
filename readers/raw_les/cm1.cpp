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

}  // namespace

std::optional<std::vector<double>> cm1Seconds(const std::string& folder, bool swapped) {
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
    // mtime stands after the planes of the variables listed before it, once per record.
    std::uint64_t before = 0;
    for (auto it = ctl.variables.begin(); it != mtime; ++it) before += it->planes();
    const bool stated = ctl.byteOrder != ByteOrder::unstated;
    if (stated) swapped = isSwapped(ctl.byteOrder);
    for (const bool order : {swapped, !swapped}) {
        const auto numbers = readNumbers(data, NumberType::float32, order, record * ctl.t.count);
        if (auto seconds = secondsIn(numbers, before, record)) return seconds;
        if (stated) break;
    }
    return {};
}

}  // namespace les
