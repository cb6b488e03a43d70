// bench_test.cpp: what `bench` measures and in which words; how fast it is is no matter of a test.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "tests/cli/program.h"

namespace {

using Json = nlohmann::json;

constexpr int kWidth = 8, kDepth = 6, kHeight = 4;

/// A small cloud at two times: 1 g/kg everywhere, then 2 g/kg.
std::string writeCloud(const std::filesystem::path& folder) {
    Json sidecar{
        {"type", "nephoscope-brick"},
        {"version", 1},
        {"shape", {kWidth, kDepth, kHeight}},
        {"spacing_m", {100, 100, 100}},
        {"byte_order", "little"},
        {"numbers", "float32"},
        {"times", {{{"label", "first"}, {"seconds", 0}}, {{"label", "second"}, {"seconds", 60}}}},
        {"variables",
         {{{"name", "qc"},
           {"role", "mixing_ratio"},
           {"species", "cloud"},
           {"unit", "g/kg"},
           {"files", {"a.bin", "b.bin"}}}}}};
    std::ofstream(folder / "cloud.json") << sidecar.dump();
    for (const char* name : {"a.bin", "b.bin"}) {
        const std::vector<float> values(kWidth * kDepth * kHeight, name[0] == 'a' ? 1.0f : 2.0f);
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(values.data()),
                   static_cast<std::streamsize>(values.size() * sizeof(float)));
    }
    return (folder / "cloud.json").string();
}

// Its solution takes no time that matters, and is worked out like any other.
const std::string kQuickLight = "--set view.light_voxels=1000 ";

Json bench(const std::string& arguments) {
    const TemporaryFolder folder;
    const Outcome outcome = runProgram("bench " + writeCloud(folder.path()) + " --size 20x16 " +
                                       kQuickLight + arguments);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return Json::parse(outcome.out);
}

void checkTimes(const Json& times) {
    CHECK(times["min_ms"] > 0.0);
    CHECK(times["min_ms"] <= times["median_ms"]);
    CHECK(times["median_ms"] <= times["max_ms"]);
}

}  // namespace

TEST_CASE("Bench draws the paper's four modes and full transport, the march beside its floor") {
    const Json modes = bench("--steps 16 --frames 2 --section modes --grid 16")["modes"];
    CHECK(contains(modes["bandwidth"].get<std::string>(), "samples x bytes per sample"));
    // [Riley03] table 4; full transport is not in it, nor has slicing it.
    const std::vector<Json> paperFps{5.1, 4.28, 1.68, 1.18, {}, 5.1, 4.28, 1.68, 1.18};
    REQUIRE(modes["rows"].size() == paperFps.size());
    for (std::size_t i = 0; i < paperFps.size(); ++i) {
        const Json& row = modes["rows"][i];
        const bool march = i < 5;
        CAPTURE(row.dump());
        checkTimes(row);
        CHECK(row["engine"] == (march ? "march" : "slicing"));
        CHECK(row["paper_fps"] == paperFps[i]);
        CHECK(row["fps"].get<double>() * row["median_ms"].get<double>() == doctest::Approx(1000.0));
        CHECK(row["grid"] == Json{16, 12, 8});
        CHECK(row["size"] == Json{20, 16});
        CHECK(row["eye_ms"] > 0.0);
        // A moved camera redoes the march's eye pass alone; slices turn with it.
        CHECK(row["frames_with_light"] == (march ? 0 : 2));
        CHECK(row["floor_ms"].is_number() == march);
        CHECK(row["samples"].is_number() == march);
        if (march) CHECK(row["eye_gb_per_s"] > 0.0);
    }
    CHECK(modes["rows"][0]["ratio_to_simplest"] == 1.0);
    // One class: a texture of four bytes at every sample, one of four at every fourth; noise.
    CHECK(modes["rows"][0]["bytes_per_sample"] == 8 * 4 + 8 * 4 / 4);
    CHECK(modes["rows"][3]["bytes_per_sample"] == 8 * 4 + 8 * 4 / 4 + 4);
}

TEST_CASE("Bench takes every size on every grid, of one engine where told") {
    const Json modes = bench(
        "--steps 16 --frames 2 --section modes --engine march --size 12x8 --grid 1 --grid 9x9x9");
    std::set<std::string> seen;
    for (const Json& row : modes["modes"]["rows"]) {
        CHECK(row["engine"] == "march");
        seen.insert(row["grid"].dump() + row["size"].dump());
    }
    // No grid is coarser than the data.
    CHECK(seen == std::set<std::string>{"[8,6,4][20,16]", "[8,6,4][12,8]", "[9,9,9][20,16]",
                                        "[9,9,9][12,8]"});
}

TEST_CASE("Bench tells the first and the full image after each kind of change") {
    const Json changes = bench("--frames 2 --section changes --grid 16")["changes"];
    CHECK(changes["engine"] == "march");
    CHECK(changes["full_size"] == Json{20, 16});
    CHECK(changes["first_size"] == Json{5, 4});
    REQUIRE(changes["rows"].size() == 4);
    const std::vector<std::string> names{"mixing-scale", "sun-azimuth", "sun-elevation", "time"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Json& row = changes["rows"][i];
        CHECK(row["change"] == names[i]);
        checkTimes(row["first"]);
        checkTimes(row["full"]);
        checkTimes(row["in_new_light"]);
        checkTimes(row["settled"]);
        CHECK(row["in_new_light"]["min_ms"] >= row["first"]["min_ms"]);
        CHECK(row["in_new_light_percent_from_settled"] >= 0.0);  // may have settled at once
        CHECK(row["in_new_light_percent_from_settled"] < 50.0);
    }
}

TEST_CASE("Bench measures the look it is told to") {
    const Json changes = bench(
        "--frames 1 --section changes --grid 16 --set light.transport=translucent")["changes"];
    for (const Json& row : changes["rows"]) CHECK_FALSE(row.contains("in_new_light"));
}

TEST_CASE("Bench doubles cells and steps as far as told, and tells the memory of a voxel") {
    const Json rows =
        bench("--steps 16 --frames 2 --section growth --grid 8 --growth-to 32")["growth"]["rows"];
    REQUIRE(rows.size() == 12);
    CHECK(rows[0]["grid"] == Json{8, 6, 4});
    CHECK(rows[4]["grid"] == Json{16, 12, 8});
    CHECK(rows[8]["grid"] == Json{32, 24, 16});
    CHECK(rows[0]["steps"] == 16);
    CHECK(rows[8]["steps"] == 64);
    CHECK(rows[3]["ratio_to_grid_before"].is_null());
    for (std::size_t i = 4; i < 12; ++i) {
        CHECK(rows[i]["ratio_to_grid_before"] > 0.0);
        const Json& bytes = rows[i]["gpu_bytes"];
        CHECK(bytes["species"] > 0);
        const double growing = bytes["species"].get<double>() + bytes["medium"].get<double>() +
                               bytes["light"].get<double>();
        const auto& grid = rows[i]["grid"];
        const double voxels = grid[0].get<double>() * grid[1].get<double>() * grid[2].get<double>();
        CHECK(rows[i]["gpu_bytes_per_voxel"].get<double>() == doctest::Approx(growing / voxels));
    }
}

TEST_CASE(
    "Bench follows the mouse as the workbench does, without its panels, until the full image") {
    const Json rows = bench("--section window --engine march")["window"]["without_panels"];
    REQUIRE(rows.size() == 1);
    checkTimes(rows[0]);
    CHECK(rows[0]["fps"] > 0.0);
    CHECK(rows[0]["rest_to_full_ms"] > 0.0);
    CHECK(rows[0]["motion_size"][0] <= 20);
}

TEST_CASE("Bench with bad usage exits with 2 and says what would be right") {
    struct Case {
        const char* arguments;
        const char* says;
    };
    for (const Case& c :
         {Case{"--section models", "modes"},
          Case{"--engine warp", "slicing"},
          Case{"--grid 0", "XxYxZ"},
          Case{"--grid 8x8", "XxYxZ"},
          Case{"--grid 8x", "XxYxZ"},
          Case{"--grid 8x8x8x", "XxYxZ"},
          Case{"--grid 9999", "from 1 to 2048"},
          Case{"--size 20", "WxH"},
          Case{"--frames 0", "--frames"},
          Case{"--steps 4", "--steps"},
          Case{"--section window --frames 3", "modes or changes or growth or reference"},
          Case{"--section reference --grid 16", "--section modes"},
          Case{"--section changes --steps 64", "modes or growth"},
          Case{"--growth-to 64", "growth"},
          Case{"--section growth --size 3x3 --size 4x4", "the first alone"},
          Case{"--section growth --engine all", "the first alone"},
          Case{"--section changes --grid 8 --grid 16", "the first alone"},
          Case{"--open --section modes", "--open"},
          Case{"--set light.sun=1", "light.sun"},
          Case{"--set view.steps=9 --set view.steps=8", "view.steps"}}) {
        CAPTURE(c.arguments);
        const Outcome outcome = runProgram(std::string("bench ") + c.arguments);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.starts_with("error: "));
        CHECK(contains(outcome.err, c.says));
    }
}
