// light_work_test.cpp: light that is solved in the background.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>

#include "core/base/progress.h"
#include "core/transport/harmonics.h"
#include "core/transport/light_work.h"
#include "core/transport/source_moments.h"
#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

LightRequest requestOf(const TransportSlab& slab) {
    LightRequest request;
    request.medium = std::make_shared<const LightMedium>(slab.medium());
    return request;
}

TransportSlab small() {
    TransportSlab slab;
    slab.nodes = {5, 5, 6};
    slab.widthToHeight = 1.0;
    return slab;
}

}  // namespace

TEST_CASE("The light that was asked for comes, settles, and says so") {
    std::atomic<int> woken = 0;
    LightWork work([&] { ++woken; });
    CHECK(work.latest() == nullptr);
    const LightRequest request = requestOf(small());
    work.ask(request);
    const auto first = work.wait(false, {});
    CHECK(first->request == request);
    const auto settled = work.wait(true, {});
    CHECK(settled->settled);
    CHECK(settled->cycles > first->cycles);
    CHECK(settled->chance >= 0.0);
    CHECK(settled->nodes.size() == 5 * 5 * 6);
    CHECK(settled->source[0].size() == settled->nodes.size() * kAlignedMoments);
    CHECK(settled->source[1].size() == settled->nodes.size() * kBroadMoments);
    CHECK(woken >= 2);
    CHECK(work.latest() == settled);
}

TEST_CASE("Another sun starts from the light that is there; the newest request wins") {
    LightWork work;
    LightRequest request = requestOf(small());
    work.ask(request);
    work.wait(false, {});
    request.warm = true;
    for (const double east : {0.1, 0.2, 0.3}) {
        request.towardsSun = glm::normalize(glm::dvec3(east, 0.0, 1.0));
        work.ask(request);
    }
    const auto warm = work.wait(true, {});
    CHECK(warm->request.towardsSun == request.towardsSun);
    request.medium = std::make_shared<const LightMedium>(small().medium());
    work.ask(request);
    CHECK(work.wait(true, {})->request.medium == request.medium);
}

TEST_CASE("Who waits for light can leave, and work that is dropped ends") {
    LightWork work;
    TransportSlab large;
    large.nodes = {32, 32, 32};
    work.ask(requestOf(large));
    CHECK_THROWS_AS(work.wait(true, [](double) { return false; }), Cancelled);
}

TEST_CASE("Parts of the sky and the ground below add up to a white furnace") {
    // Uniform surroundings of radiance 1, no absorption: everything sends out radiance 1.
    LightWork work;
    LightRequest request = requestOf(small());
    request.groundHidden = true;
    work.ask(request);
    const auto state = work.wait(true, {});
    const Harmonics up = harmonicsAt({0.0, 0.0, 1.0}, {0.0, 0.0, -1.0});
    for (std::size_t i = 0; i < state->nodes.size(); ++i) {
        double sum = 0.0;
        for (const std::size_t part : {1, 2}) {
            for (std::size_t q = 0; q < kBroadMoments; ++q) {
                sum += static_cast<double>(state->source[part][i * kBroadMoments + q] * up[q]);
            }
        }
        // Half of what reaches the ground's plane would come from a sky below.
        CHECK(sum > 0.9);
        CHECK(sum < 1.1);
    }
}

TEST_CASE("Nodes beside particles scatter as those do") {
    TransportSlab slab = small();
    LightMedium medium = slab.medium();
    LightClass& light = medium.classes.front();
    light.singleScattering = 0.9;
    for (float& extinction : light.extinctionPerM.values) extinction = 0.0f;
    light.extinctionPerM.at(2, 2, 2) = 1e-3f;
    const LightSolver solver(medium, {}, {});
    const std::vector<float> shares = filledAlbedo(solver.level());
    const auto degrees = static_cast<std::size_t>(solver.level().degreeCount);
    REQUIRE(shares.size() == 27 * degrees);
    for (std::size_t i = 0; i < 27; ++i) {
        CHECK(shares[i * degrees] == doctest::Approx(0.9));
        CHECK(shares[i * degrees + 1] == doctest::Approx(0.0));
    }
}

TEST_CASE("Light that may not start from other light is the same whatever was asked before") {
    LightRequest request = requestOf(small());
    LightWork fresh, used;
    fresh.ask(request);
    used.ask(request);
    used.wait(true, {});
    request.towardsSun = glm::normalize(glm::dvec3(0.5, 0.2, 1.0));
    fresh.ask(request);
    used.ask(request);
    CHECK(fresh.wait(true, {})->source == used.wait(true, {})->source);
}
