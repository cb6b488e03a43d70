// file_description.h: what a reader states about one file, as plain data.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/plugin/reader_abi.h"

namespace neph {

/// One time in a file.
struct FileTime {
    std::string label;
    double seconds = 0.0;  ///< on the clock that the files of a series share
};

/// One variable of a file; sizes are in cells, 1 where the variable lacks the axis.
struct FileVariable {
    std::string name, standardName, units, description;
    NephRole role = NEPH_ROLE_OTHER;
    NephSpecies species = NEPH_SPECIES_NONE;
    glm::ivec3 size{0};
};

/// Everything a reader states about one file before any field is read. Validated where it enters.
struct FileDescription {
    std::string model, scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;  ///< 0 when unknown
    glm::ivec3 size{0};
    glm::dvec2 spacingM{0.0};
    std::vector<FileTime> times;  ///< in the order of the file, at least one
    std::vector<FileVariable> variables;
    std::vector<std::string> notes;
    std::map<std::string, std::string> attributes;
};

}  // namespace neph
