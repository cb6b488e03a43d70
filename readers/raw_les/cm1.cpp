// cm1.cpp: table of CM1's microphysics schemes, after README.namelist and param.F of cm1r21.1.
#include "readers/raw_les/cm1.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "readers/raw_les/grads_ctl.h"
#include "readers/raw_les/raw_values.h"

namespace raw {
namespace {

/// A value of ptype, its hydrometeors, and the scheme whose size distributions it uses.
struct Scheme {
    int number;
    std::string_view name;
    std::string_view hydrometeors;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
};
constexpr std::string_view kWater = "qc qr";
constexpr std::string_view kFive = "qc qr qi qs qg";
constexpr std::string_view kOneIce = "qc qr qi";
// The Goddard and Gilmore schemes are versions of the scheme by Lin, Farley and Orville. Kessler's
// and Rotunno and Emanuel's have only water: what they hold below 0 °C is water as well.
constexpr std::array kSchemes{
    Scheme{0, "no microphysics", ""},
    Scheme{1, "Kessler", kWater},
    Scheme{2, "NASA Goddard LFO", kFive, NEPH_MICROPHYSICS_LIN},
    Scheme{3, "Thompson", kFive, NEPH_MICROPHYSICS_THOMPSON},
    Scheme{4, "Gilmore-Straka-Rasmussen LFO", kFive, NEPH_MICROPHYSICS_LIN},
    Scheme{5, "Morrison", kFive, NEPH_MICROPHYSICS_MORRISON},
    Scheme{6, "Rotunno-Emanuel", "ql"},
    Scheme{7, "WSM6", kFive, NEPH_MICROPHYSICS_WSM6},
    Scheme{26, "NSSL 2-moment with graupel", kFive},
    Scheme{27, "NSSL 2-moment with graupel and hail", "qc qr qi qs qg qhl"},
    Scheme{28, "NSSL 1-moment", kFive},
    Scheme{50, "P3", kOneIce},
    Scheme{51, "P3 with 2-moment cloud water", kOneIce},
    Scheme{52, "P3 with two ice categories", "qc qr qi qi2"},
    Scheme{53, "P3 3-moment", kOneIce},
    Scheme{55, "Jensen ISHMAEL", "qc qr qi1 qi2 qi3"},
};

/// Text of the first `key = value,` in a Fortran namelist; comments start with !. Empty: not there.
std::string_view namelistText(std::string_view text, std::string_view key) {
    for (std::string_view line : splitLines(text)) {
        line = line.substr(0, line.find('!'));
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) continue;
        if (toLower(trimmed(line.substr(0, equals))) != key) continue;
        const std::string_view value = line.substr(equals + 1);
        return trimmed(value.substr(0, value.find_first_of(",/")));
    }
    return {};
}

std::optional<double> namelistNumber(std::string_view text, std::string_view key) {
    return parseNumber(namelistText(text, key));
}

/// .true., .t., T and the like.
bool namelistFlag(std::string_view text, std::string_view key) {
    const std::string value = toLower(namelistText(text, key));
    return value.starts_with(".t") || value.starts_with('t');
}

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

Cm1Run parseCm1Namelist(std::string_view text) {
    Cm1Run run;
    run.terrain = namelistFlag(text, "terrain_flag");
    run.axisymmetric = namelistNumber(text, "axisymm") == 1.0;
    if (namelistNumber(text, "imove") == 1.0) {
        run.speedMPerS = {namelistNumber(text, "umove").value_or(0.0),
                          namelistNumber(text, "vmove").value_or(0.0)};
    }
    const auto number = namelistNumber(text, "ptype");
    if (!number || std::abs(*number) > 1000.0) return run;
    const auto ptype = static_cast<int>(*number);
    const auto scheme = std::ranges::find(kSchemes, ptype, &Scheme::number);
    if (scheme == kSchemes.end()) {
        run.scheme = fmt::format("ptype {}", ptype);
        return run;
    }
    run.scheme = fmt::format("{} (ptype {})", scheme->name, ptype);
    run.microphysics = scheme->microphysics;
    for (const std::string_view name : splitWords(scheme->hydrometeors)) {
        run.hydrometeors.emplace_back(name);
    }
    // Both per cm³: ndcnst belongs to the Morrison scheme, nt_c to the Thompson scheme.
    const char* key = ptype == 5 ? "ndcnst" : ptype == 3 ? "nt_c" : nullptr;
    const auto droplets = key != nullptr ? namelistNumber(text, key) : std::nullopt;
    if (droplets && *droplets > 0.0 && *droplets < 1e6) run.cloudDropletsPerM3 = *droplets * 1e6;
    // ihail = 1: the rimed ice of ptype 2 and 5 is hail rather than graupel.
    run.hail = (ptype == 2 || ptype == 5) && namelistNumber(text, "ihail") == 1.0;
    return run;
}

}  // namespace raw
