// pass_timer_test.cpp: passes of known relative length, timed.
//
// What other programs do to this machine makes times longer, never shorter: the least of several
// frames is compared.
#include "app/gl/pass_timer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "tests/gpu/context.h"

using namespace neph;

namespace {

constexpr int kValues = 4096, kFrames = 5;
constexpr int kShort = 20, kLong = 1500;  // rounds

using Times = std::vector<std::pair<std::string_view, double>>;

/// Rounds of arithmetic on the GPU, as many as asked for.
class Burner {
  public:
    Burner() {
        const std::vector<float> values(kValues, 0.5f);
        values_.write(values.data(), values.size() * sizeof(float));
    }
    void run(int rounds) {
        values_.bind(GL_SHADER_STORAGE_BUFFER, 0);
        program_.setInt(0, rounds);
        program_.dispatch({kValues, 1, 1});
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }

  private:
    gl::Program program_{NEPH_TEST_SOURCE_DIR "/tests/gpu/shaders", "burn.comp", {}};
    gl::Buffer values_;
};

/// A target that is drawn to before the passes, as a window is; or nothing.
class Drawing {
  public:
    explicit Drawing(bool wanted) {
        if (!wanted) return;
        target_ = gl::Texture::make2D(GL_RGBA8, {64, 64});
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, target_.name(), 0);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    }
    ~Drawing() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &framebuffer_);
    }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    void clear() const {
        if (framebuffer_ != 0) glClear(GL_COLOR_BUFFER_BIT);
    }

  private:
    gl::Texture target_;
    GLuint framebuffer_ = 0;
};

}  // namespace

TEST_CASE("Passes are told in the order they first ran, those of one name as one") {
    test::needContext();
    Burner burner;
    gl::PassTimer timer;
    timer.start(true);
    for (const char* name : {"light", "eye", "light", "resolve"}) {
        timer.pass(name);
        burner.run(kShort);
    }
    const Times times = timer.finish();
    REQUIRE(times.size() == 3);
    CHECK(times[0].first == "light");
    CHECK(times[1].first == "eye");
    CHECK(times[2].first == "resolve");
    for (const auto& time : times) CHECK(time.second > 0.0);
}

TEST_CASE("A timer that is off, or of a frame without passes, tells nothing") {
    test::needContext();
    gl::PassTimer timer;
    timer.pass("before any frame");
    CHECK(timer.finish().empty());
    timer.start(false);
    timer.pass("eye");
    CHECK(timer.finish().empty());
    timer.start(true);
    CHECK(timer.finish().empty());
    timer.start(true);
    timer.pass("eye");
    timer.start(true);  // the frame before was given up
    timer.pass("resolve");
    const Times times = timer.finish();
    REQUIRE(times.size() == 1);
    CHECK(times[0].first == "resolve");
    CHECK(timer.finish().empty());
}

TEST_CASE("The pass that does the work has the time, and all passes together take the frame's") {
    test::needContext();
    Burner burner;
    gl::PassTimer timer;
    burner.run(kShort);
    for (const bool afterDrawing : {false, true}) {
        CAPTURE(afterDrawing);
        const Drawing drawing(afterDrawing);
        std::array<double, 3> least{1e9, 1e9, 1e9};
        double covered = 0.0;
        for (int frame = 0; frame < kFrames; ++frame) {
            drawing.clear();
            const auto start = std::chrono::steady_clock::now();
            timer.start(true);
            const std::array<int, 3> rounds{kShort, kLong, kShort};
            const std::array<const char*, 3> names{"before", "work", "after"};
            for (std::size_t i = 0; i < rounds.size(); ++i) {
                timer.pass(names[i]);
                burner.run(rounds[i]);
            }
            const Times times = timer.finish();
            const double wallMs =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                    .count();
            REQUIRE(times.size() == least.size());
            double sumMs = 0.0;
            for (std::size_t i = 0; i < least.size(); ++i) {
                least[i] = std::min(least[i], times[i].second);
                sumMs += times[i].second;
            }
            CHECK(sumMs < 1.01 * wallMs);  // two clocks, which need not agree to the last digit
            covered = std::max(covered, sumMs / wallMs);
        }
        CHECK(least[1] > 5.0 * least[0]);  // of 75 times the arithmetic
        CHECK(least[1] > 5.0 * least[2]);
        CHECK(covered > 0.5);
    }
}
