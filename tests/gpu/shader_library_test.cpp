// shader_library_test.cpp: the driver computes what the C++ twin computes.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "shaders/lib/glsl_cpp.h"
#include "tests/gpu/context.h"

using namespace neph;

namespace {

constexpr int kSide = 24, kFunctions = 12;

std::vector<glm::vec4> inputs() {
    std::vector<glm::vec4> points;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            points.emplace_back((static_cast<float>(x) + 0.5f) / kSide,
                                (static_cast<float>(y) + 0.5f) / kSide, 0.0f, 0.0f);
        }
    return points;
}

std::vector<float> onDriver(const std::vector<glm::vec4>& points) {
    const gl::Program program(NEPH_TEST_SOURCE_DIR "/tests/gpu/shaders", "library.comp", {});
    std::vector<float> values(points.size() * kFunctions);
    gl::Buffer in, out;
    in.write(points.data(), points.size() * sizeof(glm::vec4));
    out.write(values.data(), values.size() * sizeof(float));
    in.bind(GL_SHADER_STORAGE_BUFFER, 0);
    out.bind(GL_SHADER_STORAGE_BUFFER, 1);
    program.dispatch({static_cast<int>(points.size()), 1, 1});
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.name(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(float)),
                            values.data());
    return values;
}

std::vector<float> onProcessor(glm::vec4 point) {
    const glm::vec2 u(point);
    const float cosTheta = 2.0f * u.x - 1.0f, theta = glsl::kPi * u.x;
    return {glsl::hgValue(cosTheta, 0.85f),
            glsl::hgCumulative(theta, 0.85f),
            glsl::hgSample(u.x, 0.85f),
            glsl::cornetteShanksValue(cosTheta, 0.85f),
            glsl::cornetteShanksCumulative(theta, 0.85f),
            glsl::billow(glm::vec3(u, 0.37f)),
            glsl::wisp(glm::vec3(u, 0.37f)),
            glsl::lightStepPrinted(u.x, u.y, 3.0f * u.y, 0.3f, 0.5f),
            glsl::lightStepConsistent(u.x, u.y, 3.0f * u.y, 0.9f, 0.3f, 0.5f),
            glsl::phaseTableIndex(cosTheta, 1024),
            glsl::displayValue(glm::vec3(6.0f * u.x), 1).g,
            glsl::skyRadiance(cosTheta, glm::vec3(0.1f), glm::vec3(0.5f)).r};
}

}  // namespace

TEST_CASE("The driver computes the shader library as the processor does") {
    neph::test::needContext();
    const auto points = inputs();
    const auto driver = onDriver(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto expected = onProcessor(points[i]);
        for (std::size_t f = 0; f < kFunctions; ++f) {
            CAPTURE(f);
            CAPTURE(points[i].x);
            const float scale = std::max(1.0f, std::abs(expected[f]));
            // acos of the driver is good to 4e-4 of an entry of the phase table.
            const float tolerance = f == 9 ? 2e-3f : 2e-5f;
            CHECK(std::abs(driver[i * kFunctions + f] - expected[f]) <= tolerance * scale);
        }
    }
}
