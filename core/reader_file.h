// reader_file.h: one file, opened through a reader plugin, with everything the plugin says checked.
//
// The far side of the ABI is not trusted: sizes, counts, numbers and strings are checked before
// they are used, so that a faulty plugin gives an Error and nothing worse. One ReaderFile is used
// by one thread at a time.
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/plugin_host.h"
#include "core/progress.h"

namespace neph {

struct FileTime {
    std::string label;
    double seconds = 0.0;  ///< on the clock that the files of a series share
};

struct FileVariable {
    std::string name, standardName, units, description;
    NephRole role = NEPH_ROLE_OTHER;
    NephSpecies species = NEPH_SPECIES_NONE;
    glm::ivec3 size{0};
};

/// What a reader says of one file, as plain data.
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

class ReaderFile {
  public:
    /// Opens and describes. Throws Error.
    ReaderFile(std::shared_ptr<const ReaderPlugin> reader, std::filesystem::path path);

    const FileDescription& description() const { return description_; }

    /// The cells of [lower, upper), x fastest; NaN where the reader left them unwritten. Throws
    /// Error or Cancelled.
    std::vector<float> read(std::size_t variable, std::size_t time, glm::ivec3 lower,
                            glm::ivec3 upper, const Progress& progress);

  private:
    struct Closer {
        const NephReader* calls;
        void operator()(NephFile* file) const;
    };

    std::shared_ptr<const ReaderPlugin> reader_;
    std::filesystem::path path_;
    std::unique_ptr<NephFile, Closer> file_;
    FileDescription description_;
};

}  // namespace neph
