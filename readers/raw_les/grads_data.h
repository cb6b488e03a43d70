// grads_data.h: the binary files that a GrADS descriptor names: their paths, their expected sizes
// and the times that they contain. Nothing is read before every size is verified.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "readers/raw_les/grads_ctl.h"
#include "readers/raw_les/raw_values.h"

namespace les {

/// Path of the data file of time `time` of tdef.
std::string dataPath(const Ctl& ctl, const std::filesystem::path& folder, std::size_t time);

/// The data files of one descriptor.
struct GradsData {
    /// Finds the files and checks their sizes. Throws Error.
    GradsData(const Ctl& ctl, const std::filesystem::path& folder);

    /// Location and encoding of plane number `firstPlane` at time `times[i]`. The caller sets the
    /// number of planes, the flips and the scale.
    RawField fieldAt(std::size_t i, std::uint64_t firstPlane) const;

    /// The files of `times`, each once.
    std::vector<std::string> paths() const;

    bool isSwapped() const { return plane_.swapped; }
    void swap() { plane_.swapped = !plane_.swapped; }

    std::vector<std::size_t> times;  ///< indices into tdef of the times with data; at least one
    std::vector<std::string> notes;
    /// The one file of all times has another size than stated. `times` are those that it holds, if
    /// the numbers bear out that the descriptor fits; otherwise this is the Error to throw.
    std::optional<Error> sizeFault;

  private:
    void findOne();
    void findSeries();
    void settleRecords();
    /// The Error for a file of the wrong size that should contain `count` times.
    Error sizeError(const std::string& path, std::uint64_t found, std::uint64_t count) const;
    /// The Error if the size shows what is wrong: the file is one of several tiles, has record
    /// lengths that are not stated, or lacks stated ones.
    std::optional<Error> certainError(const std::string& path, std::uint64_t found,
                                      std::uint64_t count) const;
    /// Name of a file that a single MPI rank wrote, if the folder has one.
    std::optional<std::string> tile() const;
    Error tileError(const std::string& name) const;
    [[noreturn]] void failMissing() const;

    Ctl ctl_;
    std::filesystem::path folder_;
    RawField plane_;               ///< the properties that all planes share
    std::uint64_t timeBytes_ = 0;  ///< of all variables at one time
};

}  // namespace les
