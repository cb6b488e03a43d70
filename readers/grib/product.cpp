// product.cpp: sections 1 and 4 (product definition templates 4.0 and 4.1).
#include "readers/grib/product.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/shared/calendar.h"

namespace grib {
namespace {

// Octets of GRIB are counted from 1 in WMO's tables, and from 0 here.
constexpr std::size_t kTemplateAt = 7, kCategoryAt = 9, kNumberAt = 10, kProcessAt = 13,
                      kUnitAt = 17, kForecastAt = 18, kSurfaceAt = 22, kSecondSurfaceAt = 28,
                      kMemberAt = 35;
constexpr unsigned kNoSurface = 255;

/// Seconds of a unit of code table 4.4; nothing for months and longer ones.
std::optional<double> secondsOfUnit(std::uint64_t unit) {
    switch (unit) {
        case 0:
            return 60.0;
        case 1:
            return 3600.0;
        case 2:
            return 86400.0;
        case 10:
            return 3.0 * 3600.0;
        case 11:
            return 6.0 * 3600.0;
        case 12:
            return 12.0 * 3600.0;
        case 13:
            return 1.0;
        default:
            return {};
    }
}

struct NamedParameter {
    Parameter parameter;
    const char* name;
};

/// NCEP's abbreviations, which wgrib2 prints. Code table 4.2.
constexpr std::array kNames{
    NamedParameter{{0, 0, 0}, "TMP"},       NamedParameter{{0, 0, 2}, "POT"},
    NamedParameter{{0, 0, 6}, "DPT"},       NamedParameter{{0, 0, 15}, "VPTMP"},
    NamedParameter{{0, 1, 0}, "SPFH"},      NamedParameter{{0, 1, 1}, "RH"},
    NamedParameter{{0, 1, 2}, "MIXR"},      NamedParameter{{0, 1, 22}, "CLMR"},
    NamedParameter{{0, 1, 23}, "ICMR"},     NamedParameter{{0, 1, 24}, "RWMR"},
    NamedParameter{{0, 1, 25}, "SNMR"},     NamedParameter{{0, 1, 32}, "GRLE"},
    NamedParameter{{0, 1, 71}, "HAILMXR"},  NamedParameter{{0, 1, 82}, "CIMIXR"},
    NamedParameter{{0, 1, 83}, "CLWC"},     NamedParameter{{0, 1, 84}, "CIWC"},
    NamedParameter{{0, 1, 85}, "CRWC"},     NamedParameter{{0, 1, 86}, "CSWC"},
    NamedParameter{{0, 1, 100}, "SPNCR"},   NamedParameter{{0, 1, 101}, "SPNCS"},
    NamedParameter{{0, 1, 102}, "SPNCG"},   NamedParameter{{0, 1, 103}, "SPNCH"},
    NamedParameter{{0, 1, 129}, "EFRCWAT"}, NamedParameter{{0, 1, 130}, "EFRRAIN"},
    NamedParameter{{0, 1, 131}, "EFRCICE"}, NamedParameter{{0, 1, 132}, "EFRSNOW"},
    NamedParameter{{0, 1, 133}, "EFRGRPL"}, NamedParameter{{0, 1, 134}, "EFRHAIL"},
    NamedParameter{{0, 3, 0}, "PRES"},      NamedParameter{{0, 3, 4}, "GP"},
    NamedParameter{{0, 3, 5}, "HGT"},       NamedParameter{{0, 3, 6}, "DIST"},
    NamedParameter{{0, 6, 28}, "NCONCD"},   NamedParameter{{0, 6, 29}, "NCCICE"},
};

/// A number with a decimal scale factor, as levels are stored.
double scaled(ByteSpan bytes, std::size_t at) {
    return static_cast<double>(signedAt(bytes, at + 1, 4)) *
           std::pow(10.0, static_cast<double>(-signedAt(bytes, at, 1)));
}

/// Seconds from 0001-01-01 of the reference time in section 1; nothing if it is no date.
std::optional<double> cycleOf(ByteSpan identification) {
    const auto part = [&](std::size_t at, std::size_t count) {
        return unsignedAt(identification, at, count);
    };
    return shared::secondsOfDate(fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", part(12, 2),
                                             part(14, 1), part(15, 1), part(16, 1), part(17, 1),
                                             part(18, 1)));
}

std::optional<Product> wholeProductOf(const Field& field) {
    const ByteSpan section(field.product);
    const std::uint64_t form = unsignedAt(section, kTemplateAt, 2);
    if (form > 1) return {};
    if (unsignedAt(section, kSecondSurfaceAt, 1) != kNoSurface) return {};
    const auto unit = secondsOfUnit(unsignedAt(section, kUnitAt, 1));
    const auto cycle = cycleOf(*field.identification);
    if (!unit || !cycle) return {};
    Product product;
    product.parameter = {field.discipline,
                         static_cast<unsigned>(unsignedAt(section, kCategoryAt, 1)),
                         static_cast<unsigned>(unsignedAt(section, kNumberAt, 1))};
    product.surface = static_cast<unsigned>(unsignedAt(section, kSurfaceAt, 1));
    product.level = scaled(section, kSurfaceAt + 1);
    product.cycleSeconds = *cycle;
    product.seconds = *cycle + *unit * static_cast<double>(signedAt(section, kForecastAt, 4));
    if (form == 1) product.member = static_cast<long>(unsignedAt(section, kMemberAt, 1));
    product.centre = static_cast<unsigned>(unsignedAt(*field.identification, 5, 2));
    product.process = static_cast<unsigned>(unsignedAt(section, kProcessAt, 1));
    return product;
}

}  // namespace

std::optional<Product> productOf(const Field& field) {
    try {
        return wholeProductOf(field);
    } catch (const Failure&) {  // a section ends early
        return {};
    }
}

std::string parameterName(const Parameter& parameter) {
    const auto known = std::ranges::find(kNames, parameter, &NamedParameter::parameter);
    if (known != kNames.end()) return known->name;
    return fmt::format("parameter {}-{}-{}", parameter[0], parameter[1], parameter[2]);
}

std::string levelName(unsigned surface, double level) {
    if (surface == kGround) return "the ground";
    if (surface == kIsobaric) return fmt::format("{:g} hPa", level / 100.0);
    if (surface == kHybrid) return fmt::format("hybrid level {:g}", level);
    return fmt::format("level {:g} of type {}", level, surface);
}

std::string fieldName(const Field& field) {
    std::string name = fmt::format("message {}", field.message);
    if (field.part > 1) name += fmt::format(" field {}", field.part);
    if (const auto product = productOf(field)) {
        name += fmt::format(", {} on {}", parameterName(product->parameter),
                            levelName(product->surface, product->level));
    }
    return name;
}

}  // namespace grib
