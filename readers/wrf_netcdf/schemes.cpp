// schemes.cpp: the table of mp_physics, after the packages of WRF's Registry (version 4.6.1) and,
// for what is newer or older, the Users' Guides.
#include "readers/wrf_netcdf/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace wrf {
namespace {

constexpr auto kWsm = NEPH_MICROPHYSICS_WSM6;
constexpr auto kThompson = NEPH_MICROPHYSICS_THOMPSON;
constexpr auto kMorrison = NEPH_MICROPHYSICS_MORRISON;
constexpr auto kUnknown = NEPH_MICROPHYSICS_UNKNOWN;

constexpr std::array kSchemes{
    Scheme{0, "no microphysics", ""},
    Scheme{1, "Kessler", "cr"},
    Scheme{2, "Purdue Lin", "cirsg", NEPH_MICROPHYSICS_LIN},
    Scheme{3, "WSM3", "cr", kWsm, true},
    Scheme{4, "WSM5", "cirs", kWsm},
    Scheme{5, "Ferrier-Aligo", "cir"},
    Scheme{6, "WSM6", "cirsg", kWsm},
    Scheme{7, "Goddard 4-ice", "cirsgh"},
    Scheme{8, "Thompson", "cirsg", kThompson},
    Scheme{9, "Milbrandt-Yau", "cirsgh"},
    Scheme{10, "Morrison", "cirsg", kMorrison},
    Scheme{11, "CAM 5.1", "cirs"},
    Scheme{13, "SBU-YLin", "cirs"},
    Scheme{14, "WDM5", "cirs"},
    Scheme{15, "Ferrier-Aligo, advected", "cir"},
    Scheme{16, "WDM6", "cirsg"},
    Scheme{17, "NSSL 2-moment", "cirsgh"},
    Scheme{18, "NSSL 2-moment with CCN", "cirsg"},  // hail by nssl_hail_on
    Scheme{19, "NSSL 1-moment", "cirsgh"},
    Scheme{21, "NSSL 1-moment, 6-class", "cirsg"},
    Scheme{22, "NSSL 2-moment without hail", "cirsg"},
    Scheme{24, "WSM7", "cirsgh", kWsm},
    Scheme{26, "WDM7", "cirsgh"},
    Scheme{27, "UDM", ""},
    Scheme{28, "Thompson aerosol-aware", "cirsg", kThompson},
    Scheme{29, "RCON", "cirsg"},  // of Thompson's, but with log-normal droplets
    Scheme{30, "HUJI fast spectral-bin", "cirsg"},
    Scheme{32, "HUJI full spectral-bin", "cirsgh"},
    Scheme{38, "Thompson with graupel and hail", "cirsg", kThompson},
    Scheme{40, "Morrison with aerosols", "cirsg", kMorrison},
    Scheme{50, "P3", "cir"},
    Scheme{51, "P3 with 2-moment cloud water", "cir"},
    Scheme{52, "P3 with two ice categories", "cir"},
    Scheme{53, "P3 3-moment", "cir"},
    Scheme{55, "Jensen ISHMAEL", "cir"},
    Scheme{56, "NTU", "cirsgh"},
    Scheme{95, "Eta (Ferrier, old)", "crs"},
    Scheme{96, "MAD-WRF", "cis"},
    Scheme{97, "Goddard GCE", "cirsg"},
    Scheme{98, "NCEP 3-class or Thompson 2007", "cr", kUnknown, true},
    Scheme{99, "NCEP 5-class", "cirs"},
    Scheme{106, "WSM6R", "cirsg", kWsm},
};

}  // namespace

Scheme schemeOf(int mpPhysics) {
    const auto found = std::ranges::find(kSchemes, mpPhysics, &Scheme::number);
    if (found != kSchemes.end()) return *found;
    Scheme unknown;
    unknown.number = mpPhysics;
    return unknown;
}

std::string schemeName(const Scheme& scheme) {
    if (scheme.number < 0) return {};
    if (scheme.name.empty()) return fmt::format("MP_PHYSICS {}", scheme.number);
    return fmt::format("{} (MP_PHYSICS {})", scheme.name, scheme.number);
}

}  // namespace wrf
