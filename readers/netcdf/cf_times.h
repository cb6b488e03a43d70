// cf_times.h: times that a variable states in numbers, by the conventions of CF.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/netcdf/nc_file.h"

namespace nc {

/// The times that a file holds, and the record of each.
struct FileTimes {
    std::vector<neph::plugin::Time> times;  ///< seconds from 0001-01-01 in the calendar of the file
    std::vector<std::size_t> records;       ///< indices along the axis of time, one for each time
    std::vector<std::string> notes;
    bool gregorian = true;  ///< the calendar of the file
};

/// Collects the entries that state a time, and what the others hold. `form` says in messages how
/// times are expected.
class TimeEntries {
  public:
    /// Adds an entry; without `seconds` it states no time, and `found` is what it holds.
    void add(std::size_t record, std::string label, std::optional<double> seconds,
             const std::string& found);

    /// The times; entries that state none are left out with a note. Throws Failure if no entry
    /// states a time.
    FileTimes take(const std::string& variable, const std::string& path, const char* form);

  private:
    FileTimes result_;
    std::size_t unreadable_ = 0, firstUnreadable_ = 0;
    std::string found_;
};

/// Entries of a variable of times. Throws Failure if it has an impossible number of them.
std::size_t countOf(const NcVariable& variable, const char* form);

/// Reads a variable with units such as "minutes since 2021-08-14 00:00:00". Throws Failure if they
/// are none, or no entry can be read.
FileTimes cfTimes(const NcFile& file, const NcVariable& variable, const char* form);

}  // namespace nc
