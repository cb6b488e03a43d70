// microhh_names.h: the files of a MicroHH case by name: fields, their meaning, and the .ini.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace les {

inline constexpr const char* kMicrohhGrid = "grid.0000000";

/// Meaning of a field, by its name.
struct MicrohhField {
    std::string_view name;
    NephRole role;
    NephSpecies species;
    std::string_view units, description;
};
/// Null for a field without a known meaning.
const MicrohhField* findMicrohhField(std::string_view name);

/// Names of the hydrometeors that a run with this .ini has, in the order of a table; keys as
/// parseIni gives them.
std::vector<std::string_view> hydrometeorsOf(const std::map<std::string, std::string>& keys);

/// Whether what leaves the domain of such a run on one side enters it on the other: it asks neither
/// for open sides nor for an outflow of scalars.
bool hasPeriodicSides(const std::map<std::string, std::string>& keys);

/// A file name `<variable>.<7 or more digits>`.
struct FieldName {
    std::string variable;
    std::int64_t number = 0;  ///< the digits: time in units of 10^iotimeprec seconds
};
/// Nothing for any other name.
std::optional<FieldName> fieldName(const std::string& name);

/// Whether a file is the .ini of a case: it has a section [grid].
bool isCaseIni(const std::string& path);
/// The .ini files of cases in a folder, sorted.
std::vector<std::string> iniFiles(const std::string& folder);

}  // namespace les
