// periodic_sides_test.cpp: light that goes through the volume again beyond its sides, against the
// path tracer, a volume that really has the repeats, and what a plane layer must look like.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "tests/gpu/images.h"
#include "tests/gpu/periodic_scenes.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

// Straight down, nearly from infinity: the middle three quarters of the domain.
const CameraPose kFromAbove{{0.5f, 0.5f, 0.5f}, 6.0f, 180.0f, 90.0f, 5.0f};

/// Of each column of the image, from west to east.
std::vector<double> columnsOf(const ImageF& image) {
    std::vector<double> means(static_cast<std::size_t>(image.size.x), 0.0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double luminance =
            glm::dot(glm::dvec3(image.pixels[i]), glm::dvec3(0.2126, 0.7152, 0.0722));
        means[i % means.size()] += luminance / image.size.y;
    }
    return means;
}

/// How far the column that differs most from the middle one does.
double unevenness(const ImageF& image) {
    const std::vector<double> columns = columnsOf(image);
    const double middle = columns[columns.size() / 2];
    double most = 0.0;
    for (const double column : columns) most = std::max(most, std::abs(column / middle - 1.0));
    return most;
}

/// The relative error of the march's mean, where the noise of the reference's is about 1 %.
double biasBetweenSides(const SpeciesVolume& volume, const CameraPose& pose, float elevationDeg) {
    render::FrameInputs inputs =
        periodicFrame(volume, Transport::full, DomainSides::periodic, pose, {16, 12});
    inputs.look.sunElevationDeg = elevationDeg;
    const auto meanOf = [&](const render::FrameInputs& of, int samples) {
        const std::vector<double> columns = columnsOf(averageOn(volume, of, samples));
        return std::accumulate(columns.begin(), columns.end(), 0.0);
    };
    render::FrameInputs traced = inputs;
    traced.look.engine = Engine::reference;
    return meanOf(inputs, 4) / meanOf(traced, 192) - 1.0;
}

}  // namespace

TEST_CASE("Between periodic sides a plane layer is as bright at its sides as in the middle") {
    const SpeciesVolume volume = uniformVolume({12, 12, 5}, 300.0, 1.5e-5f);
    for (const Transport transport :
         {Transport::lowAlbedo, Transport::translucent, Transport::full}) {
        CAPTURE(static_cast<int>(transport));
        render::FrameInputs inputs =
            periodicFrame(volume, transport, DomainSides::periodic, kFromAbove, {12, 6});
        CHECK(unevenness(averageOn(volume, inputs, 4)) < 0.01);
        inputs.look.domainSides = DomainSides::open;
        CHECK(unevenness(averageOn(volume, inputs, 4)) > 0.05);
    }
}

TEST_CASE("Between periodic sides paths find a plane layer as bright at its sides") {
    const SpeciesVolume volume = uniformVolume({12, 12, 5}, 300.0, 1.5e-5f);
    render::FrameInputs inputs =
        periodicFrame(volume, Transport::full, DomainSides::periodic, kFromAbove, {8, 4});
    inputs.look.engine = Engine::reference;
    const auto westOverEast = [&] {
        const std::vector<double> columns = columnsOf(averageOn(volume, inputs, 192));
        const double west = std::accumulate(columns.begin(), columns.begin() + 4, 0.0);
        return west / std::accumulate(columns.begin() + 4, columns.end(), 0.0);
    };
    CHECK(westOverEast() == doctest::Approx(1.0).epsilon(0.04));
    inputs.look.domainSides = DomainSides::open;
    CHECK(westOverEast() > 1.15);
}

TEST_CASE("Sunlight between periodic sides is that in the midst of neighbours") {
    const SpeciesVolume volume = brokenClouds(2), nine = nineOf(volume);
    for (const Transport transport : {Transport::lowAlbedo, Transport::translucent}) {
        CAPTURE(static_cast<int>(transport));
        render::FrameInputs inputs =
            periodicFrame(volume, transport, DomainSides::periodic, kFromAbove, {24, 18});
        inputs.look.sunElevationDeg = 12.0f;  // shadows are as long as the domain at most
        const ImageF repeated = averageOn(volume, inputs, 2);
        inputs.look.domainSides = DomainSides::open;
        const double fromNine = luminanceError(repeated, averageOn(nine, inputs, 2));
        CHECK(fromNine < 0.03);
        CHECK(luminanceError(repeated, averageOn(volume, inputs, 2)) > 3.0 * fromNine);
    }
}

TEST_CASE("Between periodic sides full transport has the light of the path tracer, from above") {
    const SpeciesVolume volume = brokenClouds();
    CHECK(std::abs(biasBetweenSides(volume, kFromAbove, 35.0f)) < 0.03);
}

TEST_CASE("Between periodic sides full transport has the light of the path tracer, from below") {
    const SpeciesVolume volume = brokenClouds();
    CHECK(std::abs(biasBetweenSides(volume, views()[6].pose, 35.0f)) < 0.03);
}

TEST_CASE("Between periodic sides full transport has the light of the path tracer from a low sun") {
    const SpeciesVolume volume = brokenClouds();
    CHECK(std::abs(biasBetweenSides(volume, views()[0].pose, 8.0f)) < 0.05);
}

TEST_CASE("In a white furnace with periodic sides nothing can be told from the sky") {
    const SpeciesVolume volume = brokenClouds();
    for (const Engine engine : {Engine::march, Engine::reference}) {
        CAPTURE(static_cast<int>(engine));
        render::FrameInputs inputs = periodicFrame(volume, Transport::full, DomainSides::periodic,
                                                   views()[0].pose, {16, 12});
        inputs.look.engine = engine;
        inputs.look.sunIntensity = 0.0f;
        inputs.look.skyZenith = inputs.look.skyHorizon = glm::vec3(1.0f);
        inputs.look.groundVisible = false;
        for (const glm::vec4& pixel : averageOn(volume, inputs, 2).pixels) {
            CHECK(pixel.r == doctest::Approx(1.0).epsilon(0.02));
        }
    }
}

TEST_CASE("Sides that are changed and changed back leave nothing behind") {
    const SpeciesVolume volume = brokenClouds();
    renderer().setVolume(volume);
    for (const Engine engine : {Engine::march, Engine::reference}) {
        CAPTURE(static_cast<int>(engine));
        render::FrameInputs inputs =
            periodicFrame(volume, Transport::full, DomainSides::open, views()[0].pose, {12, 9});
        inputs.look.engine = engine;
        std::vector<ImageF> images;
        for (const DomainSides sides :
             {DomainSides::open, DomainSides::periodic, DomainSides::open, DomainSides::periodic}) {
            inputs.look.domainSides = sides;
            const Stage redone = renderer().render(inputs).redone;
            CHECK(redone == (Stage::medium));
            images.push_back(renderer().readLinear());
        }
        CHECK(worstDifference(images[0], images[1]) > 0.0f);
        CHECK(worstDifference(images[0], images[2]) == 0.0f);
        CHECK(worstDifference(images[1], images[3]) == 0.0f);
    }
}

TEST_CASE("Half-angle slicing has open sides, and says so once where periodic ones are asked for") {
    const SpeciesVolume volume = brokenClouds();
    render::FrameInputs inputs =
        periodicFrame(volume, Transport::translucent, DomainSides::open, views()[0].pose, {24, 18});
    inputs.look.engine = Engine::slicing;
    const ImageF open = renderOn(volume, inputs);
    renderer().takeMessages();
    inputs.look.domainSides = DomainSides::periodic;
    CHECK(worstDifference(open, renderOn(volume, inputs)) == 0.0f);
    const std::vector<std::string> messages = renderer().takeMessages();
    REQUIRE(messages.size() == 1);
    CHECK(messages[0].find("domain.sides=periodic") != std::string::npos);
    CHECK(messages[0].find("view.engine=march") != std::string::npos);
    renderOn(volume, inputs);
    CHECK(renderer().takeMessages().empty());
}
