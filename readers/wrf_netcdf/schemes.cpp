// schemes.cpp: the table of mp_physics, after the WRF Users' Guide, version 4.
#include "readers/wrf_netcdf/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace wrf {
namespace {

/// A value of mp_physics, and the scheme whose size distributions it uses.
struct Scheme {
    int number;
    std::string_view name;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
};

constexpr std::array kSchemes{
    Scheme{0, "no microphysics"},
    Scheme{1, "Kessler"},
    Scheme{2, "Purdue Lin", NEPH_MICROPHYSICS_LIN},
    Scheme{3, "WSM3", NEPH_MICROPHYSICS_WSM6},
    Scheme{4, "WSM5", NEPH_MICROPHYSICS_WSM6},
    Scheme{5, "Ferrier"},
    Scheme{6, "WSM6", NEPH_MICROPHYSICS_WSM6},
    Scheme{7, "Goddard"},
    Scheme{8, "Thompson", NEPH_MICROPHYSICS_THOMPSON},
    Scheme{9, "Milbrandt-Yau"},
    Scheme{10, "Morrison", NEPH_MICROPHYSICS_MORRISON},
    Scheme{11, "CAM 5.1"},
    Scheme{13, "SBU-YLin"},
    Scheme{14, "WDM5"},
    Scheme{16, "WDM6"},
    Scheme{17, "NSSL 2-moment"},
    Scheme{18, "NSSL 2-moment with CCN"},
    Scheme{19, "NSSL 1-moment"},
    Scheme{21, "NSSL 1-moment, 6-class"},
    Scheme{22, "NSSL 2-moment without hail"},
    Scheme{24, "WSM7", NEPH_MICROPHYSICS_WSM6},
    Scheme{26, "WDM7"},
    Scheme{28, "Thompson aerosol-aware", NEPH_MICROPHYSICS_THOMPSON},
    Scheme{30, "HUJI fast spectral-bin"},
    Scheme{32, "HUJI full spectral-bin"},
    Scheme{40, "Morrison with aerosols", NEPH_MICROPHYSICS_MORRISON},
    Scheme{50, "P3"},
    Scheme{51, "P3 with 2-moment cloud water"},
    Scheme{52, "P3 with two ice categories"},
    Scheme{53, "P3 3-moment"},
    Scheme{55, "Jensen ISHMAEL"},
    Scheme{56, "NTU"},
    Scheme{95, "Eta (Ferrier, old)"},
};

}  // namespace

std::string schemeName(int mpPhysics) {
    const auto found = std::ranges::find(kSchemes, mpPhysics, &Scheme::number);
    if (found == kSchemes.end()) return fmt::format("MP_PHYSICS {}", mpPhysics);
    return fmt::format("{} (MP_PHYSICS {})", found->name, mpPhysics);
}

NephMicrophysics microphysicsOf(int mpPhysics) {
    const auto found = std::ranges::find(kSchemes, mpPhysics, &Scheme::number);
    return found == kSchemes.end() ? NEPH_MICROPHYSICS_UNKNOWN : found->microphysics;
}

}  // namespace wrf
