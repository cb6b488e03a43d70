// cm1.cpp: tables of CM1's output variables and of its microphysics schemes, after README.namelist
// of cm1r21.1.
#include "readers/raw_les/cm1.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "readers/raw_les/grads_ctl.h"

namespace raw {
namespace {

constexpr std::array kKnown{
    KnownVariable{"qc", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_CLOUD, Quantity::ratio,
                  "cloud_liquid_water_mixing_ratio"},
    KnownVariable{"ql", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_CLOUD, Quantity::ratio, ""},
    KnownVariable{"qr", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_RAIN, Quantity::ratio, ""},
    KnownVariable{"qi", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_ICE, Quantity::ratio,
                  "cloud_ice_mixing_ratio"},
    KnownVariable{"qs", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_SNOW, Quantity::ratio, ""},
    KnownVariable{"qg", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_GRAUPEL, Quantity::ratio, ""},
    KnownVariable{"qh", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_HAIL, Quantity::ratio, ""},
    KnownVariable{"qhl", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_HAIL, Quantity::ratio, ""},
    KnownVariable{"ncc", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_CLOUD, Quantity::number, ""},
    KnownVariable{"ncr", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_RAIN, Quantity::number, ""},
    KnownVariable{"nci", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_ICE, Quantity::number, ""},
    KnownVariable{"ncs", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_SNOW, Quantity::number, ""},
    KnownVariable{"ncg", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_GRAUPEL, Quantity::number,
                  ""},
    KnownVariable{"effc", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_CLOUD, Quantity::radius,
                  "effective_radius_of_cloud_liquid_water_particles"},
    KnownVariable{"effr", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_RAIN, Quantity::radius, ""},
    KnownVariable{"effi", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_ICE, Quantity::radius, ""},
    KnownVariable{"effs", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_SNOW, Quantity::radius, ""},
    KnownVariable{"effg", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_GRAUPEL, Quantity::radius, ""},
    KnownVariable{"prs", NEPH_ROLE_AIR_PRESSURE, NEPH_SPECIES_NONE, Quantity::pressure,
                  "air_pressure"},
    KnownVariable{"rho", NEPH_ROLE_DRY_AIR_DENSITY, NEPH_SPECIES_NONE, Quantity::density, ""},
    KnownVariable{"th", NEPH_ROLE_OTHER, NEPH_SPECIES_NONE, Quantity::temperature,
                  "air_potential_temperature"},
    KnownVariable{"qv", NEPH_ROLE_OTHER, NEPH_SPECIES_NONE, Quantity::ratio,
                  "humidity_mixing_ratio"},
};

/// A value of ptype, and the scheme whose size distributions it uses.
struct Scheme {
    int number;
    std::string_view name;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
};
// The Goddard and Gilmore schemes are versions of the scheme by Lin, Farley and Orville.
constexpr std::array kSchemes{
    Scheme{0, "no microphysics"},
    Scheme{1, "Kessler"},
    Scheme{2, "NASA Goddard LFO", NEPH_MICROPHYSICS_LIN},
    Scheme{3, "Thompson", NEPH_MICROPHYSICS_THOMPSON},
    Scheme{4, "Gilmore-Straka-Rasmussen LFO", NEPH_MICROPHYSICS_LIN},
    Scheme{5, "Morrison", NEPH_MICROPHYSICS_MORRISON},
    Scheme{6, "Rotunno-Emanuel"},
    Scheme{7, "WSM6", NEPH_MICROPHYSICS_WSM6},
    Scheme{26, "NSSL 2-moment with graupel"},
    Scheme{27, "NSSL 2-moment with graupel and hail"},
    Scheme{28, "NSSL 1-moment"},
    Scheme{50, "P3"},
    Scheme{51, "P3 with 2-moment cloud water"},
    Scheme{52, "P3 with two ice categories"},
    Scheme{53, "P3 3-moment"},
    Scheme{55, "Jensen ISHMAEL"},
};

/// Value of the first `key = value,` in a Fortran namelist; comments start with !.
std::optional<double> namelistNumber(std::string_view text, std::string_view key) {
    for (std::string_view line : splitLines(text)) {
        line = line.substr(0, line.find('!'));
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) continue;
        if (toLower(trimmed(line.substr(0, equals))) != key) continue;
        std::string_view value = line.substr(equals + 1);
        return parseNumber(trimmed(value.substr(0, value.find_first_of(",/"))));
    }
    return {};
}

}  // namespace

const KnownVariable* findKnown(std::string_view name) {
    const std::string spelling = toLower(name);
    const auto found = std::ranges::find(kKnown, spelling, &KnownVariable::name);
    return found == kKnown.end() ? nullptr : &*found;
}

std::string knownHydrometeors() {
    std::vector<std::string> names;
    for (const KnownVariable& known : kKnown) {
        if (known.role == NEPH_ROLE_MIXING_RATIO) names.emplace_back(known.name);
    }
    return joined(names);
}

std::optional<std::vector<double>> cm1Seconds(const std::string& folder) {
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
    const auto numbers =
        readNumbers(data, NumberType::float32, isSwapped(ctl.byteOrder), record * ctl.t.count);
    std::vector<double> seconds;
    for (std::size_t i = before; i < numbers.size(); i += record) {
        const bool later = seconds.empty() || numbers[i] > seconds.back();
        if (!std::isfinite(numbers[i]) || !later) return {};  // damaged: CM1 writes in time order
        seconds.push_back(numbers[i]);
    }
    return seconds;
}

Cm1Run parseCm1Namelist(std::string_view text) {
    Cm1Run run;
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
    // Both per cm³: ndcnst belongs to the Morrison scheme, nt_c to the Thompson scheme.
    const char* key = ptype == 5 ? "ndcnst" : ptype == 3 ? "nt_c" : nullptr;
    const auto droplets = key != nullptr ? namelistNumber(text, key) : std::nullopt;
    if (droplets && *droplets > 0.0 && *droplets < 1e6) run.cloudDropletsPerM3 = *droplets * 1e6;
    // ihail = 1: the rimed ice of ptype 2 and 5 is hail rather than graupel.
    run.hail = (ptype == 2 || ptype == 5) && namelistNumber(text, "ihail") == 1.0;
    return run;
}

}  // namespace raw
