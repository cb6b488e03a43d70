// microhh_names.cpp: tables and name patterns, after MicroHH's microphys_*.cxx and
// thermo_moist.cxx.
#include "readers/raw_les/microhh_names.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "readers/les/text.h"
#include "readers/raw_les/ini.h"

namespace les {
namespace {

// Hydrometeors are mass fractions, per kg of moist air; the density to multiply by is rhoref.
constexpr std::array kFields{
    MicrohhField{"ql", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_CLOUD, "kg kg-1", "cloud water"},
    MicrohhField{"qi", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_ICE, "kg kg-1", "cloud ice"},
    MicrohhField{"qr", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_RAIN, "kg kg-1", "rain"},
    MicrohhField{"qs", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_SNOW, "kg kg-1", "snow"},
    MicrohhField{"qg", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_GRAUPEL, "kg kg-1", "graupel"},
    MicrohhField{"qh", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_HAIL, "kg kg-1", "hail"},
    MicrohhField{"nr", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_RAIN, "m-3",
                 "number of rain drops"},
};

/// A value of a switch of the .ini, and the hydrometeors that it brings.
struct Switch {
    std::string_view key, value, hydrometeors;
};
// Cloud water and ice are diagnosed from total water; precipitation is prognostic.
constexpr std::array kSwitches{
    Switch{"thermo/swthermo", "moist", "ql"},
    Switch{"micro/swmicro", "2mom_warm", "ql qr"},
    Switch{"micro/swmicro", "nsw6", "ql qi qr qs qg"},
};

}  // namespace

const MicrohhField* findMicrohhField(std::string_view name) {
    const auto found = std::ranges::find(kFields, name, &MicrohhField::name);
    return found == kFields.end() ? nullptr : &*found;
}

std::vector<std::string_view> hydrometeorsOf(const std::map<std::string, std::string>& keys) {
    std::vector<std::string_view> names;
    for (const MicrohhField& field : kFields) {
        const bool has = std::ranges::any_of(kSwitches, [&](const Switch& each) {
            const auto found = keys.find(std::string(each.key));
            return found != keys.end() && found->second == each.value &&
                   std::ranges::count(splitWords(each.hydrometeors), field.name) > 0;
        });
        if (has) names.push_back(field.name);
    }
    return names;
}

bool hasPeriodicSides(const std::map<std::string, std::string>& keys) {
    return std::ranges::none_of(keys, [](const auto& each) {
        const bool asks =
            each.first == "boundary_lateral/sw_openbc" || each.first == "boundary/scalar_outflow";
        return asks && !each.second.empty() && each.second != "0" && each.second != "false";
    });
}

std::optional<FieldName> fieldName(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || dot == 0 || name.size() - dot - 1 < 7) return {};
    const std::string_view digits = std::string_view(name).substr(dot + 1);
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return {};
    const auto number = parseInteger(digits);
    if (!number) return {};
    return FieldName{name.substr(0, dot), *number};
}

bool isCaseIni(const std::string& path) {
    const auto text = findText(path);
    return text && parseIni(*text).contains("grid/itot");
}

std::vector<std::string> iniFiles(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        if (entry.path().extension() == ".ini" && isCaseIni(path)) found.push_back(path);
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace les
