// wrf_times.cpp: Times of WRF, and CF times.
#include "readers/wrf_netcdf/wrf_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/shared/calendar.h"
#include "readers/shared/writing.h"

namespace wrf {
namespace {

constexpr std::size_t kMaxTimes = 1'000'000;
constexpr std::size_t kMaxLength = 1024;  // of one text
constexpr const char* kForm = "Times(Time, DateStrLen) as YYYY-MM-DD_hh:mm:ss, or a CF time";

/// A text of Times for messages: NULs and other unprintable characters are shown as ?.
std::string shown(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
    }
    return '"' + text + '"';
}

/// Collects the entries that state a time, and what the others hold.
class Entries {
  public:
    void add(std::size_t record, std::string label, std::optional<double> seconds,
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

    /// Throws Failure if no entry states a time.
    FileTimes take(const std::string& variable, const std::string& path) {
        if (unreadable_ == 0) return std::move(result_);
        const auto writing = shared::beingWritten(path);
        if (result_.times.empty()) {
            throw Failure{
                fmt::format("entry {} of variable {} cannot be read", firstUnreadable_, variable),
                found_, kForm,
                writing ? fmt::format("the file is being written ({}): open it again when that has "
                                      "ended",
                                      *writing)
                        : "the model was interrupted while writing this time, or the file is "
                          "damaged"};
        }
        const bool atEnd = firstUnreadable_ > result_.records.back();
        result_.notes.push_back(fmt::format(
            "{} of {} times {} left out, because {} does not state {} (entry {} is {}){}.",
            unreadable_, unreadable_ + result_.times.size(), unreadable_ == 1 ? "is" : "are",
            variable, unreadable_ == 1 ? "it" : "them", firstUnreadable_, found_,
            !atEnd    ? ""
            : writing ? ": the model seems to be writing"
                      : ": the model seems to have stopped while it wrote"));
        return std::move(result_);
    }

  private:
    FileTimes result_;
    std::size_t unreadable_ = 0, firstUnreadable_ = 0;
    std::string found_;
};

/// Throws Failure if a variable of times has an impossible size.
std::size_t countOf(const NcVariable& variable) {
    const std::size_t count = variable.axes.front().length;
    if (count > 0 && count <= kMaxTimes) return count;
    throw Failure{count == 0 ? fmt::format("the file contains no time (dimension {} has no length)",
                                           variable.axes.front().name)
                             : fmt::format("variable {} has an impossible size", variable.name),
                  listOf(variable.axes), kForm, "the model may not have written a time yet"};
}

FileTimes fromTexts(const NcFile& file, const NcVariable& variable) {
    const std::size_t count = countOf(variable);
    std::vector<std::string> texts;
    if (variable.strings) {
        texts = file.readStrings(variable);
    } else {
        const std::size_t length = variable.axes[1].length;
        if (length > kMaxLength) {
            throw Failure{"variable Times has an impossible size", listOf(variable.axes), kForm,
                          "the file is damaged: copy it again"};
        }
        const std::array<std::size_t, 2> start{0, 0};
        const std::array<std::size_t, 2> whole{count, length};
        const std::string text = file.readText(variable, start, whole);
        for (std::size_t i = 0; i < count; ++i) texts.push_back(text.substr(i * length, length));
    }
    Entries entries;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        std::string label =
            texts[i].substr(0, texts[i].find_last_not_of(std::string_view(" \0", 2)) + 1);
        const auto seconds = shared::secondsOfDate(label);
        if (seconds && label.size() > 10) label[10] = '_';
        entries.add(i, label, seconds, shown(texts[i]));
    }
    return entries.take(variable.name, file.path());
}

/// The variable that states times in numbers: a coordinate of the axis of time, or one along it;
/// null if there is none.
const NcVariable* cfTime(const NcFile& file, const Axes& axes) {
    const auto states = [&](const NcVariable& variable) {
        const bool alone = variable.axes.empty() ||
                           (variable.axes.size() == 1 && variable.axes[0].name == axes.time);
        return variable.number && alone && variable.units.find(" since ") != std::string::npos;
    };
    for (const std::string& name : {axes.time, std::string("XTIME"), std::string("time")}) {
        const NcVariable* variable = file.variable(name);
        if (variable != nullptr && states(*variable)) return variable;
    }
    const auto found = std::ranges::find_if(file.variables(), states);
    return found == file.variables().end() ? nullptr : &*found;
}

FileTimes fromNumbers(const NcFile& file, const NcVariable& variable) {
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
        count = {countOf(variable)};
    }
    std::vector<double> numbers = file.readDoubles(variable, start, count);
    variable.packing.unpack(numbers);
    Entries entries;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double seconds = std::round(1e3 * unit->secondsOf(numbers[i])) / 1e3;
        const bool known = std::isfinite(seconds) && seconds >= 0.0 && seconds < 3.2e11;
        entries.add(i, known ? shared::dateOfSeconds(seconds, *calendar) : std::string(),
                    known ? std::optional(seconds) : std::nullopt, fmt::format("{}", numbers[i]));
    }
    FileTimes times = entries.take(variable.name, file.path());
    times.gregorian = *calendar == shared::Calendar::gregorian;
    return times;
}

/// Times of a file that states none: counted, where the attributes do not help.
FileTimes counted(const NcFile& file, const Axes& axes) {
    const NcDimension* dimension = axes.time.empty() ? nullptr : file.dimension(axes.time);
    const std::size_t count = dimension == nullptr ? 1 : dimension->length;
    const auto start = file.text("START_DATE");
    const auto seconds = start ? shared::secondsOfDate(*start) : std::nullopt;
    if (count != 1) {
        throw Failure{"the file does not state its times",
                      fmt::format("{} records, and neither Times nor a variable with units such as "
                                  "\"minutes since 2021-08-14 00:00:00\"",
                                  count),
                      kForm,
                      "keep Times when you process the file (ncks -v Times,…, or cdo with "
                      "XTIME)"};
    }
    FileTimes times;
    times.records = {0};
    times.times = {{seconds ? *start : std::string("unknown time"), seconds.value_or(0.0)}};
    times.notes.push_back(seconds
                              ? "The file does not state its time: the start of the run is taken."
                              : "The file does not state its time.");
    return times;
}

}  // namespace

FileTimes readTimes(const NcFile& file, const Axes& axes) {
    const NcVariable* texts = file.variable("Times");
    if (texts != nullptr &&
        ((texts->text && texts->axes.size() == 2) || (texts->strings && texts->axes.size() == 1))) {
        try {
            return fromTexts(file, *texts);
        } catch (const Failure&) {
            if (cfTime(file, axes) == nullptr) throw;
        }
    }
    if (const NcVariable* numbers = cfTime(file, axes)) return fromNumbers(file, *numbers);
    return counted(file, axes);
}

}  // namespace wrf
