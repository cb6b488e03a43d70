// session_haze_test.cpp: humidity is read when a look asks for it, once for each time, and arrives
// with its volume.
#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/look/haze.h"
#include "core/session/session.h"
#include "tests/core/memory_dataset.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

std::shared_ptr<Dataset> humidTimes() {
    const glm::ivec3 size(2, 2, 2);
    auto dataset = std::make_shared<MemoryDataset>(
        size, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset->addRatio(Species::cloud, [](int, int, int) { return 1e-3f; });
    dataset->add("p", VariableRole::airPressure, {}, size, [](int, int, int) { return 1e5f; });
    dataset->add("T", VariableRole::airTemperature, {}, size,
                 [](int, int, int) { return 298.15f; });
    dataset->add("qv", VariableRole::waterVapour, {}, size, [](int, int, int) { return 0.014f; });
    dataset->addTime("2024-05-06_21:10:00", "second");
    dataset->addTime("2024-05-06_21:20:00", "third", {"qv"});
    return dataset;
}

bool pollUntilShown(Session& session) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < until) {
        session.poll();
        if (session.info() != nullptr && session.shows(session.document.time)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

/// A session that shows one of the times, or loads it.
struct Humid {
    TemporaryFolder folder;
    Session session{
        [](std::span<const std::filesystem::path>, const Progress&) { return humidTimes(); }};

    Humid(Haze haze, int time) {
        std::ofstream(folder / "memory") << "0";
        session.document.look.skyModel = SkyModel::atmosphere;
        session.document.look.haze = haze;
        session.open(std::array{(folder / "memory").string()}, time);
    }
    int said(std::string_view text) const {
        return static_cast<int>(std::ranges::count_if(
            session.messages,
            [&](const Message& message) { return contains(message.text, text); }));
    }
};

}  // namespace

TEST_CASE("Asking for haze by humidity reads the humidity and keeps the volume") {
    Humid humid(Haze::fixed, 0);
    Session& session = humid.session;
    REQUIRE(pollUntilShown(session));
    REQUIRE(session.takeVolume() != nullptr);
    CHECK_FALSE(session.where().humidity.has_value());

    const auto before = session.held()->volume;
    session.document.look.haze = Haze::humidity;
    REQUIRE(pollUntilShown(session));
    // 1e5 Pa, 25 °C and 14 g/kg, as in lowest_air_test.cpp
    CHECK(session.where().humidity.value_or(0.0) == doctest::Approx(0.694967).epsilon(1e-5));
    CHECK(session.held()->volume == before);
    CHECK(session.takeVolume() == nullptr);  // the renderer has it

    session.document.look.haze = Haze::fixed;
    REQUIRE(pollUntilShown(session));
    CHECK(session.takeVolume() == nullptr);
    CHECK(session.timesHeld() >= 1);

    // Another time comes with its humidity, so that its light is found once.
    session.document.look.haze = Haze::humidity;
    session.document.time = 1;
    REQUIRE(pollUntilShown(session));
    CHECK(session.takeVolume() != nullptr);
    CHECK(session.where().humidity.has_value());
}

TEST_CASE(
    "A time without vapour has the haze of the look, and a message says so while it is shown") {
    Humid humid(Haze::humidity, 2);
    Session& session = humid.session;
    REQUIRE(pollUntilShown(session));
    const auto said = [&] {
        return humid.said(
            "21:20:00: haze does not follow the humidity: there is no "
            "water vapour at this time; visibility 100 km");
    };
    CHECK(said() == 1);
    CHECK(lookAsDrawn(session.document.look, session.where()).visibilityM == 100e3f);
    session.document.time = 0;
    REQUIRE(pollUntilShown(session));
    CHECK(said() == 0);
    CHECK(lookAsDrawn(session.document.look, session.where()).visibilityM < 31e3f);
}

TEST_CASE("Asking for haze by aerosol says at once that the data have none, and takes it back") {
    Humid humid(Haze::humidity, 0);
    Session& session = humid.session;
    REQUIRE(pollUntilShown(session));
    const auto said = [&] {
        return humid.said(
            "haze does not follow the aerosol: the data have no number of "
            "hygroscopic aerosol; visibility 30.1 km by a relative humidity of 69 "
            "% of the lowest air");
    };
    CHECK(said() == 0);
    session.document.look.haze = Haze::aerosol;
    REQUIRE(pollUntilShown(session));
    CHECK(said() == 1);
    REQUIRE(pollUntilShown(session));
    CHECK(said() == 1);
    session.document.look.haze = Haze::humidity;
    REQUIRE(pollUntilShown(session));
    CHECK(said() == 0);
}
