// droplets_test.cpp: populations of water droplets against tabulated values (docs/physics.md §6),
// and their cache.
#include "core/optics/droplets.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <numbers>
#include <sstream>
#include <string>

#include "core/optics/droplet_cache.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"

using namespace neph;
using doctest::Approx;
namespace fs = std::filesystem;

namespace {

/// Computed once for all tests of this file.
const DropletOptics& tenMicrons() {
    static const DropletOptics optics = computeDroplets(10e-6f);
    return optics;
}

double at(const std::vector<float>& table, double degrees) {
    const double s = std::sqrt(degrees / 180.0) * (kPhaseTableSize - 1);
    const auto i = std::min(static_cast<std::size_t>(s), table.size() - 2);
    const double f = s - static_cast<double>(i);
    return (1.0 - f) * static_cast<double>(table[i]) + f * static_cast<double>(table[i + 1]);
}

std::vector<float> channel(const PhaseTable& table, int colour) {
    std::vector<float> values;
    for (const glm::vec3& v : table) values.push_back(v[colour]);
    return values;
}

/// An empty home of the cache.
struct TemporaryCache {
    TemporaryFolder folder;
    Environment variable{"XDG_CACHE_HOME", folder.path().string()};
};

void checkSame(const DropletOptics& a, const DropletOptics& b) {
    CHECK(a.effectiveRadiusM == b.effectiveRadiusM);
    CHECK(a.phase == b.phase);
    CHECK(a.cumulative == b.cumulative);
    CHECK(a.asymmetry == b.asymmetry);
    CHECK(a.extinctionEfficiency == b.extinctionEfficiency);
}

}  // namespace

// The tabulated asymmetry and efficiency carry ±0.0005 of their own from the sampling of radii,
// ours likewise.
TEST_CASE("Droplets of 5, 10 and 20 µm have the tabulated efficiency and asymmetry at 550 nm") {
    struct Row {
        float radiusM;
        double efficiency, asymmetry;
    };
    for (const Row& row :
         {Row{5e-6f, 2.145, 0.8489}, Row{10e-6f, 2.089, 0.8646}, Row{20e-6f, 2.058, 0.8724}}) {
        CAPTURE(row.radiusM);
        const DropletOptics optics =
            row.radiusM == 10e-6f ? tenMicrons() : computeDroplets(row.radiusM);
        CHECK(std::abs(static_cast<double>(optics.extinctionEfficiency.y) - row.efficiency) < 2e-3);
        CHECK(std::abs(static_cast<double>(optics.asymmetry.y) - row.asymmetry) < 1e-3);
    }
}

TEST_CASE("Droplets of 10 µm have the tabulated efficiency and asymmetry at 450 and 650 nm") {
    CHECK(std::abs(tenMicrons().extinctionEfficiency.z - 2.079f) < 2e-3f);
    CHECK(std::abs(tenMicrons().asymmetry.z - 0.8656f) < 1e-3f);
    CHECK(std::abs(tenMicrons().extinctionEfficiency.x - 2.100f) < 2e-3f);
    CHECK(std::abs(tenMicrons().asymmetry.x - 0.8615f) < 1e-3f);
}

TEST_CASE("A gram of 10 µm droplets has the cross-section that weather models use, 156.87 m²/kg") {
    // Band 442-625 nm of RRTMG in WRF 4.2.2, docs/physics.md §6
    const double k =
        3.0 * static_cast<double>(tenMicrons().extinctionEfficiency.y) / (4.0 * 1000.0 * 10e-6);
    CHECK(k == Approx(156.87).epsilon(3e-3));
}

TEST_CASE("Droplets of 10 µm have the tabulated phase function, peak, rainbow and glory included") {
    struct Row {
        double degrees, blue, green, red;
    };
    for (const Row& row :
         {Row{0, 880, 592, 426}, Row{1, 115.6, 140.3, 146.8}, Row{2, 9.81, 12.3, 16.4},
          Row{5, 1.204, 1.348, 1.480}, Row{10, .591, .608, .624}, Row{20, .333, .334, .338},
          Row{30, .1826, .1817, .1814}, Row{60, .0207, .0208, .0211},
          Row{90, .00209, .00213, .00224}, Row{120, .00348, .00326, .00320},
          Row{140, .0245, .0240, .0230}, Row{160, .0098, .0097, .0100},
          Row{180, .0519, .0522, .0504}}) {
        CAPTURE(row.degrees);
        // Forward light is smooth in the size; behind, both tables sample interference that sizes
        // barely average out.
        const double tolerance = row.degrees <= 2 ? 5e-3 : row.degrees <= 60 ? 1.5e-2 : 9e-2;
        const double expected[] = {row.red, row.green, row.blue};
        for (int c = 0; c < 3; ++c) {
            CHECK(at(channel(tenMicrons().phase, c), row.degrees) ==
                  Approx(expected[c]).epsilon(tolerance));
        }
    }
}

TEST_CASE("Droplets of 10 µm have the tabulated cumulative at 550 nm") {
    struct Row {
        double degrees, share;
    };
    for (const Row& row : {Row{1, .293}, Row{2, .416}, Row{5, .481}, Row{10, .539}, Row{20, .663},
                           Row{30, .778}, Row{60, .940}, Row{90, .963}, Row{180, 1.0}}) {
        CAPTURE(row.degrees);
        CHECK(std::abs(at(tenMicrons().cumulative, row.degrees) - row.share) < 1.2e-3);
    }
}

TEST_CASE("Droplets agree with the reference tables over all angles") {
    const fs::path folder = fs::path(NEPH_TEST_SOURCE_DIR) / "tests/core/optics/data";
    const char* names[] = {"650", "550", "450"};
    for (int colour = 0; colour < 3; ++colour) {
        std::ifstream file(folder / ("mie_water_reff10_" + std::string(names[colour]) + "nm.csv"));
        const std::vector<float> ours = channel(tenMicrons().phase, colour);
        double squares = 0.0, worstForward = 0.0, worstShare = 0.0;
        int rows = 0;
        for (std::string line; std::getline(file, line);) {
            if (line.empty() || line[0] == '#') continue;
            std::istringstream fields(line);
            double degrees = 0.0, value = 0.0, share = 0.0;
            char comma = 0;
            fields >> degrees >> comma >> value >> comma >> share;
            const double error = at(ours, degrees) / value - 1.0;
            squares += error * error;
            if (degrees <= 2.0) worstForward = std::max(worstForward, std::abs(error));
            if (colour == 1) {
                worstShare =
                    std::max(worstShare, std::abs(at(tenMicrons().cumulative, degrees) - share));
            }
            ++rows;
        }
        REQUIRE(rows > 200);
        CAPTURE(names[colour]);
        CHECK(worstForward < 1e-2);
        CHECK(std::sqrt(squares / rows) < 5e-2);  // the reference's own sampling of radii: 2 to 4 %
        CHECK(worstShare < 1.2e-3);
    }
}

TEST_CASE("Radii outside the range are those of its ends") {
    CHECK(computeDroplets(1e-9f).effectiveRadiusM == kSmallestDropletM);
    CHECK(dropletCacheFile(1.0f) == dropletCacheFile(kLargestDropletM));
    CHECK(dropletCacheFile(10.04e-6f) == dropletCacheFile(10e-6f));
    CHECK(dropletCacheFile(10.1e-6f) != dropletCacheFile(10e-6f));
}

TEST_CASE("Droplets come back from the cache exactly as they were written") {
    const TemporaryCache cache;
    const DropletOptics made = computeDroplets(1e-6f);
    const fs::path path = dropletCacheFile(1e-6f);
    CHECK(path.parent_path() == cache.folder / "nephoscope");
    CHECK(!readDropletCache(path, 1e-6f));
    REQUIRE(writeDropletCache(path, made));
    const auto read = readDropletCache(path, 1e-6f);
    REQUIRE(read);
    checkSame(*read, made);
    CHECK(!readDropletCache(path, 2e-6f));
    CHECK(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()) == 1);
}

TEST_CASE("A cache file that is cut, too long or has one flipped bit counts as absent") {
    const TemporaryCache cache;
    const fs::path path = dropletCacheFile(1e-6f);
    REQUIRE(writeDropletCache(path, computeDroplets(1e-6f)));
    std::ostringstream whole;
    whole << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string good = whole.str();
    auto reads = [&](const std::string& bytes) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
        return readDropletCache(path, 1e-6f).has_value();
    };
    REQUIRE(reads(good));
    CHECK(!reads(""));
    CHECK(!reads(good.substr(0, good.size() - 1)));
    CHECK(!reads(good + "x"));
    for (std::size_t i : {std::size_t{0}, std::size_t{8}, std::size_t{12}, std::size_t{16},
                          std::size_t{20}, good.size() / 2, good.size() - 1}) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 4);
        CAPTURE(i);
        CHECK(!reads(bad));
    }
}

TEST_CASE("A corrupt or unwritable cache costs time, never an error") {
    const TemporaryCache cache;
    const fs::path path = dropletCacheFile(1.2e-6f);
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "not droplets";
    const auto recomputed = waterDroplets(1.2e-6f);
    checkSame(*recomputed, computeDroplets(1.2e-6f));
    CHECK(readDropletCache(path, 1.2e-6f).has_value());  // mended

    const Environment nowhere("XDG_CACHE_HOME", "/proc/nowhere");
    const auto uncached = waterDroplets(1.3e-6f);
    CHECK(uncached->phase.size() == static_cast<std::size_t>(kPhaseTableSize));
    CHECK(!writeDropletCache(dropletCacheFile(1.3e-6f), *uncached));
    CHECK(waterDroplets(1.3e-6f) == uncached);  // kept in memory all the same
}

TEST_CASE("Droplets at 800 nm are those of the IPRT intercomparison") {
    // C. Emde et al., JQSRT 164, 8 (2015), file watercloud.mie: effective radius 10 um; extinction
    // 158.707 /km per g/m³; angle in degrees, 4 pi P.
    constexpr std::array<std::array<double, 2>, 9> kPublished{{{0.0, 3557.28},
                                                               {1.0, 1725.61},
                                                               {2.0, 304.029},
                                                               {3.0, 69.7879},
                                                               {5.0, 21.0644},
                                                               {10.0, 8.21334},
                                                               {20.0, 4.26965},
                                                               {40.0, 1.15827},
                                                               {50.0, 0.568663}}};
    const auto droplets = waterDroplets(10e-6f, 800e-9f);
    CHECK(static_cast<double>(droplets->extinctionEfficiency.y) ==
          doctest::Approx(158.707e-3 * 4.0 / 3.0 * 10.0).epsilon(1e-3));
    for (const auto& each : kPublished) {
        const double angle = each[0], value = each[1];
        CAPTURE(angle);
        const auto cosine = static_cast<float>(std::cos(angle * std::numbers::pi / 180.0));
        CHECK(4.0 * std::numbers::pi * static_cast<double>(lookUp(droplets->phase, cosine).y) ==
              doctest::Approx(value).epsilon(0.012));
    }
}
