// session_notes_test.cpp: what is said of a time goes when the time goes.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/session/session.h"
#include "tests/core/memory_dataset.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

/// Cloud, rain that is zero, and at the second time no rain at all.
std::shared_ptr<Dataset> twoTimes() {
    auto dataset = std::make_shared<MemoryDataset>(
        glm::ivec3(4, 4, 4), [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset->addRatio(Species::cloud, [](int, int, int) { return 1e-3f; });
    dataset->addRatio(Species::rain, [](int, int, int) { return 0.0f; });
    dataset->stated().notes = {"The map scale factor is not applied."};
    dataset->addTime("2024-05-06_21:10:00", "second", {"Q_rain"});
    return dataset;
}

bool showTime(Session& session, int time) {
    session.document.time = time;
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < until) {
        session.poll();
        if (!session.loading() && session.info() != nullptr && session.shows(time)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

std::ptrdiff_t timesSaid(const Session& session, std::string_view text) {
    return std::ranges::count_if(
        session.messages, [&](const Message& message) { return contains(message.text, text); });
}

}  // namespace

TEST_CASE("What is said of a time names it, goes when another is shown, and comes back with it") {
    const TemporaryFolder folder;
    std::ofstream(folder / "memory") << "0";
    Session session(
        [](std::span<const std::filesystem::path>, const Progress&) { return twoTimes(); });
    session.open(std::array{(folder / "memory").string()}, 0);
    const char* const zero = "2024-05-06_21:00:00: Q_rain: zero everywhere at this time";
    const char* const lacking = "2024-05-06_21:10:00: Q_rain is not in second";
    for (const int round : {0, 1}) {
        CAPTURE(round);
        REQUIRE(showTime(session, 0));
        CHECK(timesSaid(session, zero) == 1);
        CHECK(timesSaid(session, lacking) == 0);
        REQUIRE(showTime(session, 1));
        CHECK(timesSaid(session, zero) == 0);
        CHECK(timesSaid(session, lacking) == 1);
        CHECK(session.takeVolume() != nullptr);
        CHECK(timesSaid(session, "map scale factor") == 1);  // of the series: it stays
    }
    for (std::size_t i = 1; i < session.messages.size(); ++i) {
        CHECK(session.messages[i].serial > session.messages[i - 1].serial);
    }
}
