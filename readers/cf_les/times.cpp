// times.cpp: variables of time, with and without a date.
#include "readers/cf_les/times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/cf_les/axes.h"
#include "readers/les/text.h"
#include "readers/shared/calendar.h"
#include "readers/shared/units.h"

namespace cf {
namespace {

constexpr const char* kForm = "seconds, or \"seconds since YYYY-MM-DD hh:mm:ss\"";
constexpr double kMostSeconds = 3.2e11;  // ten thousand years

/// The variable of times: named as its dimension, or along it with a unit of time; null if there is
/// none.
const nc::NcVariable* timeVariable(const nc::NcFile& file, const std::string& dimension) {
    const auto fits = [&](const nc::NcVariable* variable) {
        if (variable == nullptr || !variable->number) return false;
        if (dimension.empty()) return variable->axes.empty() || variable->axes[0].length == 1;
        return variable->axes.size() == 1 && variable->axes[0].name == dimension;
    };
    for (const std::string& name : {dimension, std::string("time"), std::string("Time")}) {
        const nc::NcVariable* variable = name.empty() ? nullptr : named(file, name);
        if (fits(variable)) return variable;
    }
    return nullptr;
}

/// Seconds of the unit in which times are counted from the start of the run. "seconds since start"
/// and the like state no date; without any unit they are seconds.
double secondsPerUnit(const nc::NcVariable& variable, std::vector<std::string>& notes) {
    std::string unit = variable.units.substr(0, variable.units.find(" since "));
    if (unit == "sec" || unit == "secs") unit = "s";
    if (unit.starts_with("time units")) unit.clear();  // of MicroHH's 3d_to_nc.py
    if (unit.empty()) {
        notes.push_back(
            fmt::format("Times are taken as seconds: {} states no unit.", variable.name));
        return 1.0;
    }
    const auto toSeconds = shared::conversion(unit, "s");
    if (toSeconds && toSeconds->scale > 0.0) return toSeconds->scale;
    throw nc::Failure{fmt::format("the times of variable {} cannot be read", variable.name),
                      fmt::format("units \"{}\"", variable.units), kForm,
                      "set the attribute with ncatted"};
}

std::string labelOf(double seconds) {
    return fmt::format("{:.6g} s", seconds);
}

Times undated(const nc::NcFile& file, const nc::NcVariable& variable) {
    Times times;
    std::vector<std::string> notes;
    const double scale = secondsPerUnit(variable, notes);
    std::vector<std::size_t> start, count;
    if (!variable.axes.empty()) {
        start = {0};
        count = {nc::countOf(variable, kForm)};
    }
    std::vector<double> numbers = file.readDoubles(variable, start, count);
    variable.packing.unpack(std::span<double>(numbers));
    nc::TimeEntries entries;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double seconds = numbers[i] * scale;
        const bool known = std::abs(seconds) < kMostSeconds;
        entries.add(i, known ? labelOf(seconds) : std::string(),
                    known ? std::optional(seconds) : std::nullopt, fmt::format("{}", numbers[i]));
    }
    static_cast<nc::FileTimes&>(times) = entries.take(variable.name, file.path(), kForm);
    times.gregorian = false;
    for (std::string& note : notes) times.notes.push_back(std::move(note));
    return times;
}

}  // namespace

Times timesOf(const nc::NcFile& file, const std::string& dimension) {
    const nc::NcVariable* variable = timeVariable(file, dimension);
    if (variable != nullptr) {
        const auto calendar = shared::calendarNamed(variable->calendar);
        const bool dated = calendar && shared::timeUnit(variable->units, *calendar).has_value();
        if (!dated) return undated(file, *variable);
        Times times;
        static_cast<nc::FileTimes&>(times) = nc::cfTimes(file, *variable, kForm);
        times.dated = true;
        return times;
    }
    const nc::NcDimension* records = dimension.empty() ? nullptr : file.dimension(dimension);
    const std::size_t count = records == nullptr ? 1 : records->length;
    if (count != 1) {
        throw nc::Failure{
            "the file does not state its times",
            fmt::format("{} records along {}, and no variable of times", count, dimension), kForm,
            "keep the coordinate of time when you process the file"};
    }
    Times times;
    times.records = {0};
    times.times = {{"unknown time", 0.0}};
    times.gregorian = false;
    times.notes.emplace_back("The file does not state its time.");
    return times;
}

}  // namespace cf
