// wrf_times.cpp: Times of WRF, and CF times.
#include "readers/wrf_netcdf/wrf_times.h"

#include <fmt/format.h>

#include <algorithm>

#include "readers/shared/calendar.h"

namespace wrf {
namespace {

constexpr std::size_t kMaxLength = 1024;  // of one text
constexpr const char* kForm = "Times(Time, DateStrLen) as YYYY-MM-DD_hh:mm:ss, or a CF time";

/// A text of Times for messages: NULs and other unprintable characters are shown as ?.
std::string shown(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
    }
    return '"' + text + '"';
}

FileTimes fromTexts(const NcFile& file, const NcVariable& variable) {
    const std::size_t count = nc::countOf(variable, kForm);
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
    nc::TimeEntries entries;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        std::string label =
            texts[i].substr(0, texts[i].find_last_not_of(std::string_view(" \0", 2)) + 1);
        const auto seconds = shared::secondsOfDate(label);
        if (seconds && label.size() > 10) label[10] = '_';
        entries.add(i, label, seconds, shown(texts[i]));
    }
    return entries.take(variable.name, file.path(), kForm);
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
    if (const NcVariable* numbers = cfTime(file, axes)) return nc::cfTimes(file, *numbers, kForm);
    return counted(file, axes);
}

}  // namespace wrf
