// progress_lines.cpp: the lines, each flushed so that it is read at once.
#include "app/cli/common/progress_lines.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace neph {
namespace {

constexpr auto kPause = std::chrono::milliseconds(500);

/// Who no longer reads is no reason to stop.
void say(const nlohmann::ordered_json& line) {
    const std::string text =
        line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void ProgressLines::part(double share) {
    if (!wanted_ || Clock::now() - told_ < kPause) return;
    told_ = Clock::now();
    say({{"done", done_}, {"of", of_}, {"seconds", secondsSince(start_)}, {"part", share}});
}

void ProgressLines::done(const std::filesystem::path& file) {
    ++done_;
    if (!wanted_) return;
    told_ = Clock::now();
    say({{"done", done_}, {"of", of_}, {"seconds", secondsSince(start_)}, {"file", file.string()}});
}

void ProgressLines::failed(const std::string& message) {
    say({{"error", message}});
}

}  // namespace neph
