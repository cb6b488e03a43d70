// grads_data.h: the flat files that a GrADS descriptor names: where they are, how large they must
// be, which times they hold. Nothing is read before every size is right.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "readers/raw_les/grads_ctl.h"
#include "readers/raw_les/raw_values.h"

namespace raw {

/// Path of the data file of a time of tdef.
std::string dataPath(const Ctl& ctl, const std::filesystem::path& folder, std::size_t time);

struct GradsData {
    /// Finds the files and checks their sizes. Throws Error.
    GradsData(const Ctl& ctl, const std::filesystem::path& folder);

    /// Where the plane with number `firstPlane` of the time `times[i]` begins, and how its numbers
    /// are written; the caller says the rest.
    RawField fieldAt(std::size_t i, std::uint64_t firstPlane) const;

    std::vector<std::size_t> times;  ///< of tdef, those that are there; at least one
    std::vector<std::string> notes;

  private:
    void findOne();
    void findSeries();
    void requireSize(const std::string& path, std::uint64_t found, std::uint64_t count) const;
    std::optional<std::string> tile() const;
    [[noreturn]] void failWithTile(const std::string& name) const;
    [[noreturn]] void failMissing() const;

    Ctl ctl_;
    std::filesystem::path folder_;
    RawField plane_;  ///< one horizontal plane
    std::uint64_t timeBytes_ = 0;
};

}  // namespace raw
