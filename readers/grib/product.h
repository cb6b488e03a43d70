// product.h: which quantity a field is, at which level and time.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "readers/grib/sections.h"

namespace grib {

/// Discipline, category and number: code tables 0.0, 4.1 and 4.2.
using Parameter = std::array<unsigned, 3>;

/// Code table 4.5.
enum Surface : unsigned { kGround = 1, kIsobaric = 100, kHybrid = 105 };

struct Product {
    Parameter parameter{};
    unsigned surface = 0;              ///< code table 4.5
    double level = 0.0;                ///< Pa on isobaric surfaces, the number of a hybrid level
    double cycleSeconds = 0.0;         ///< start of the forecast, from 0001-01-01
    double seconds = 0.0;              ///< when it holds
    long member = -1;                  ///< of an ensemble; -1 without one
    unsigned centre = 0, process = 0;  ///< who made it, and the process by that centre's table
};

/// What an instantaneous field on one surface is; nothing for layers, accumulations, means,
/// probabilities, templates that are not known, and sections that are too short.
std::optional<Product> productOf(const Field& field);

/// "CLMR", or "parameter 0-1-240" for one without a name here.
std::string parameterName(const Parameter& parameter);

/// "hybrid level 7", "500 hPa", "the ground".
std::string levelName(unsigned surface, double level);

/// "message 17, CLMR on hybrid level 7", as far as it is known.
std::string fieldName(const Field& field);

}  // namespace grib
