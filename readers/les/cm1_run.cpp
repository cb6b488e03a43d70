// cm1_run.cpp: table of CM1's microphysics schemes, after README.namelist and param.F of cm1r21.1.
#include "readers/les/cm1_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "readers/les/text.h"

namespace les {
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

}  // namespace

Cm1Run cm1RunOf(int ptype) {
    Cm1Run run;
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
    return run;
}

Cm1Run parseCm1Namelist(std::string_view text) {
    const auto number = namelistNumber(text, "ptype");
    const bool stated = number && std::abs(*number) <= 1000.0;
    const int ptype = stated ? static_cast<int>(*number) : 0;
    Cm1Run run = stated ? cm1RunOf(ptype) : Cm1Run{};
    run.terrain = namelistFlag(text, "terrain_flag");
    run.axisymmetric = namelistNumber(text, "axisymm") == 1.0;
    if (namelistNumber(text, "imove") == 1.0) {
        run.speedMPerS = {namelistNumber(text, "umove").value_or(0.0),
                          namelistNumber(text, "vmove").value_or(0.0)};
    }
    // Both per cm³: ndcnst belongs to the Morrison scheme, nt_c to the Thompson scheme.
    const char* key = ptype == 5 ? "ndcnst" : ptype == 3 ? "nt_c" : nullptr;
    const auto droplets = key != nullptr ? namelistNumber(text, key) : std::nullopt;
    if (droplets && *droplets > 0.0 && *droplets < 1e6) run.cloudDropletsPerM3 = *droplets * 1e6;
    // ihail = 1: the rimed ice of ptype 2 and 5 is hail rather than graupel.
    run.hail = (ptype == 2 || ptype == 5) && namelistNumber(text, "ihail") == 1.0;
    return run;
}

}  // namespace les
