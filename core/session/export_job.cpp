// export_job.cpp: reads progress lines, and estimates the remaining time from what is done.
#include "core/session/export_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace neph {
namespace {

constexpr int kNiceness = 10;    // the window has priority
constexpr double kLeastS = 1.0;  // elapsed time before the remaining time can be estimated
constexpr double kLeastShare = 0.01;

}  // namespace

std::string durationText(double seconds) {
    const auto s = static_cast<long>(std::lround(std::max(seconds, 0.0)));
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
    return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

ExportJob::ExportJob(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments)
    : child_(program, arguments, {.niceness = kNiceness, .takesInput = false, .mayOutlive = true}) {
}

/// Takes one line of progress; other output is skipped.
void ExportJob::take(const std::string& line) {
    const auto told = nlohmann::json::parse(line, nullptr, false);
    if (!told.is_object()) return;
    const auto number = [&](const char* key, double otherwise) {
        const auto found = told.find(key);
        return found != told.end() && found->is_number() ? found->get<double>() : otherwise;
    };
    done_ = static_cast<int>(std::clamp(number("done", done_), 0.0, 1e9));
    of_ = static_cast<int>(std::clamp(number("of", of_), 0.0, 1e9));
    seconds_ = number("seconds", seconds_);
    part_ = std::clamp(number("part", 0.0), 0.0, 1.0);
    if (const auto file = told.find("file"); file != told.end() && file->is_string()) {
        file_ = file->get<std::string>();
    }
    if (const auto error = told.find("error"); error != told.end() && error->is_string()) {
        error_ = error->get<std::string>();
    }
}

ExportJob::State ExportJob::poll() {
    if (state_ != State::running) return state_;
    const bool runs = child_.poll();
    for (const std::string& line : child_.takeLines()) take(line);
    if (runs) return state_;
    const bool well = child_.status() == 0;
    state_ = well ? State::done : cancelling_ ? State::cancelled : State::failed;
    return state_;
}

void ExportJob::cancel() {
    cancelling_ = true;
    child_.cancel();
}

double ExportJob::fraction() const {
    return of_ == 0 ? 0.0 : std::min((done_ + part_) / of_, 1.0);
}

std::string ExportJob::text() const {
    if (cancelling_ && state_ == State::running) return "Stopping";
    if (of_ == 0) return "Preparing";
    const std::string done = of_ == 1 ? fmt::format("{:.0f} %", 100.0 * fraction())
                                      : fmt::format("{} of {} images", done_, of_);
    if (done_ == of_) return done + ", finishing";
    if (seconds_ < kLeastS || fraction() < kLeastShare) return done;
    return fmt::format("{}, {} left", done,
                       durationText(seconds_ * (1.0 - fraction()) / fraction()));
}

std::string ExportJob::fault() const {
    if (!error_.empty()) return error_;
    const std::string words = child_.lastWords();  // it ended before it could report why
    return words.empty() ? fmt::format("the program ended with {}", child_.status().value_or(-1))
                         : words;
}

}  // namespace neph
