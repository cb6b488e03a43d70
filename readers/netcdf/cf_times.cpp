// cf_times.cpp: numbers of a unit of time since a date, in the calendars of CF.
#include "readers/netcdf/cf_times.h"

#include <fmt/format.h>

#include <cmath>

#include "readers/shared/calendar.h"
#include "readers/shared/writing.h"

namespace nc {
namespace {

constexpr std::size_t kMaxTimes = 1'000'000;

}  // namespace

void TimeEntries::add(std::size_t record, std::string label, std::optional<double> seconds,
                      const std::string& found) {
    if (seconds) {
        result_.times.push_back({std::move(label), *seconds});
        result_.records.push_back(record);
        return;
    }
    ++unreadable_;
    if (unreadable_ > 1) return;
    firstUnreadable_ = record;
    found_ = found;
}

FileTimes TimeEntries::take(const std::string& variable, const std::string& path,
                            const char* form) {
    if (unreadable_ == 0) return std::move(result_);
    const auto writing = shared::beingWritten(path);
    if (result_.times.empty()) {
        throw Failure{
            fmt::format("entry {} of variable {} cannot be read", firstUnreadable_, variable),
            found_, form,
            writing ? fmt::format("the file is being written ({}): open it again when that has "
                                  "ended",
                                  *writing)
                    : "the model was interrupted while writing this time, or the file is "
                      "damaged"};
    }
    const bool atEnd = firstUnreadable_ > result_.records.back();
    result_.notes.push_back(fmt::format(
        "{} of {} times {} left out, because {} does not state {} (entry {} is {}){}.", unreadable_,
        unreadable_ + result_.times.size(), unreadable_ == 1 ? "is" : "are", variable,
        unreadable_ == 1 ? "it" : "them", firstUnreadable_, found_,
        !atEnd    ? ""
        : writing ? ": the model seems to be writing"
                  : ": the model seems to have stopped while it wrote"));
    return std::move(result_);
}

std::size_t countOf(const NcVariable& variable, const char* form) {
    const std::size_t count = variable.axes.front().length;
    if (count > 0 && count <= kMaxTimes) return count;
    throw Failure{count == 0 ? fmt::format("the file contains no time (dimension {} has no length)",
                                           variable.axes.front().name)
                             : fmt::format("variable {} has an impossible size", variable.name),
                  listOf(variable.axes), form, "the model may not have written a time yet"};
}

FileTimes cfTimes(const NcFile& file, const NcVariable& variable, const char* form) {
    const auto calendar = shared::calendarNamed(variable.calendar);
    const auto unit = calendar ? shared::timeUnit(variable.units, *calendar) : std::nullopt;
    if (!unit) {
        throw Failure{
            fmt::format("the times of variable {} cannot be read", variable.name),
            fmt::format("units \"{}\", calendar \"{}\"", variable.units, variable.calendar),
            "\"minutes since YYYY-MM-DD hh:mm:ss\" in a calendar of CF",
            "set the attributes with ncatted"};
    }
    std::vector<std::size_t> start, count;
    if (!variable.axes.empty()) {
        start = {0};
        count = {countOf(variable, form)};
    }
    std::vector<double> numbers = file.readDoubles(variable, start, count);
    variable.packing.unpack(numbers);
    TimeEntries entries;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double seconds = std::round(1e3 * unit->secondsOf(numbers[i])) / 1e3;
        const bool known = std::isfinite(seconds) && seconds >= 0.0 && seconds < 3.2e11;
        entries.add(i, known ? shared::dateOfSeconds(seconds, *calendar) : std::string(),
                    known ? std::optional(seconds) : std::nullopt, fmt::format("{}", numbers[i]));
    }
    FileTimes times = entries.take(variable.name, file.path(), form);
    times.gregorian = *calendar == shared::Calendar::gregorian;
    return times;
}

}  // namespace nc
