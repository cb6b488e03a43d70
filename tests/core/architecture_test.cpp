// architecture_test.cpp: who may include whom, read from the sources themselves.
// docs/architecture.md
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "core/look/engines.h"

using neph::EngineTraits, neph::kEngines;

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = NEPH_TEST_SOURCE_DIR;

struct Include {
    std::string from, target;
};

std::vector<std::string> sourcesUnder(const std::string& room) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / room)) {
        const std::string kind = entry.path().extension();
        if (kind == ".h" || kind == ".cpp") {
            files.push_back(fs::relative(entry.path(), kRoot).string());
        }
    }
    return files;
}

std::vector<Include> includesUnder(const std::string& room) {
    static const std::regex pattern(R"re(^\s*#include\s+[<"]([^>"]+)[>"])re");
    std::vector<Include> found;
    for (const std::string& file : sourcesUnder(room)) {
        std::ifstream stream(kRoot / file);
        for (std::string line; std::getline(stream, line);) {
            std::smatch match;
            if (std::regex_search(line, match, pattern)) found.push_back({file, match[1]});
        }
    }
    REQUIRE(!found.empty());
    return found;
}

void forbid(const std::string& room, const std::string& pattern) {
    const std::regex forbidden(pattern);
    for (const Include& include : includesUnder(room)) {
        CAPTURE(include.from);
        CAPTURE(include.target);
        CHECK_FALSE(std::regex_search(include.target, forbidden));
    }
}

const std::string kGl = "^(epoxy|GL|GLES[0-9]*|EGL)/";
const std::string kWindow = "^GLFW/";
const std::string kImgui = "^imgui";

/// Floors of a building, the lowest first; the rooms on one floor do not know each other.
using Floors = std::vector<std::vector<std::string>>;

const Floors kCore{{"core/base", "core/grid"},
                   {"core/geo", "core/sky"},
                   {"core/image", "core/plugin", "core/optics", "core/camera", "core/air"},
                   {"core/dataset", "core/look", "core/transport", "core/plot"},
                   {"core/volume"},
                   {"core/analysis"},
                   {"core/preset"},
                   {"core/session"}};

const std::string kEngineRooms = "app/render/engines/";

std::vector<std::string> engineRooms() {
    std::vector<std::string> rooms;
    for (const EngineTraits& engine : kEngines)
        rooms.push_back(kEngineRooms + std::string(engine.id));
    return rooms;
}

const Floors kRender{{"app/render/light", "app/render/sky"},
                     {"app/render/medium"},
                     {"app/render/frame"},
                     engineRooms(),
                     {"app/render"}};

const Floors kCommands{
    {"app/cli/common"},
    {"app/workbench"},
    {"app/cli/render", "app/cli/info"},
    {"app/cli/ask", "app/cli/bench", "app/cli/compare"},
    {"app/cli"},
};

/// Rooms of panels know widgets and what every panel is given; the shell alone knows all panels.
const Floors kPanels{{"app/ui/widgets"},
                     {"app/ui/panel"},
                     {"app/ui/fields", "app/ui/presets", "app/ui/compare", "app/ui/output",
                      "app/ui/data", "app/ui/time"},
                     {"app/ui/camera"},
                     {"app/ui/ask"},
                     {"app/ui/shell"}};

std::string roomOf(const std::string& path) {
    return path.substr(0, path.rfind('/'));
}

/// Checks that every file lies in a room of `floors` and includes, of these rooms, its own and
/// those on floors below.
void checkFloors(const std::string& building, const Floors& floors) {
    std::map<std::string, std::size_t> floorOf;
    for (std::size_t floor = 0; floor < floors.size(); ++floor) {
        for (const std::string& room : floors[floor]) floorOf[room] = floor;
    }
    for (const Include& include : includesUnder(building)) {
        const std::string from = roomOf(include.from), target = roomOf(include.target);
        CAPTURE(include.from);
        CAPTURE(include.target);
        REQUIRE(floorOf.contains(from));
        if (!include.target.starts_with(building + "/") || from == target) continue;
        REQUIRE(floorOf.contains(target));
        CHECK(floorOf[target] < floorOf[from]);
    }
}

}  // namespace

TEST_CASE("Rooms of core include only rooms on floors below them") {
    checkFloors("core", kCore);
}

TEST_CASE("Rooms of the renderer include only rooms on floors below them") {
    checkFloors("app/render", kRender);
}

TEST_CASE("The renderer knows no engine: one is a row of the table and a room of its own") {
    for (const std::string& room : engineRooms()) CHECK(fs::is_directory(kRoot / room));
    for (const Include& include : includesUnder("app/render")) {
        CAPTURE(include.from);
        CAPTURE(include.target);
        const bool engine = include.from.starts_with(kEngineRooms);
        CHECK((engine || !include.target.starts_with(kEngineRooms)));
    }
}

TEST_CASE("No file but those of its room names an engine") {
    std::string names;
    for (const EngineTraits& engine : kEngines) {
        names += (names.empty() ? "" : "|") + std::string(engine.id);
    }
    const std::regex named("Engine::(" + names + R"()\b)");
    int files = 0;
    for (const std::string building : {"core", "app"}) {
        for (const std::string& file : sourcesUnder(building)) {
            ++files;
            if (file.starts_with(kEngineRooms)) continue;
            std::ifstream stream(kRoot / file);
            for (std::string line; std::getline(stream, line);) {
                CAPTURE(file);
                CAPTURE(line);
                CHECK_FALSE(std::regex_search(line, named));
            }
        }
    }
    CHECK(files > 200);
}

TEST_CASE("Rooms of the command line include only rooms on floors below them") {
    checkFloors("app/cli", kCommands);
}

TEST_CASE("Rooms of panels include only rooms on floors below them") {
    checkFloors("app/ui", kPanels);
}

TEST_CASE("Core knows neither GL, ImGui, NetCDF nor the rooms above it") {
    forbid("core", kGl + "|" + kWindow + "|" + kImgui + "|^netcdf|^app/|^readers/");
}

TEST_CASE("Headers of core keep JSON to themselves") {
    for (const Include& include : includesUnder("core")) {
        if (include.from.ends_with(".h"))
            CHECK(include.target.find("nlohmann") == std::string::npos);
    }
}

TEST_CASE("Readers see of core what any third party is given, and no more") {
    for (const Include& include : includesUnder("readers")) {
        CAPTURE(include.from);
        CAPTURE(include.target);
        const bool house =
            include.target.starts_with("core/") || include.target.starts_with("app/");
        const bool given = include.target == "core/plugin/reader_abi.h" ||
                           include.target == "core/plugin/reader_plugin.h";
        CHECK((!house || given));
    }
}

TEST_CASE("Panels make no GL call and know no renderer") {
    forbid("app/ui", kGl + "|" + kWindow + "|^app/(gl|render|cli|image_io|workbench)/");
}

TEST_CASE("Only app/gl and app/render include GL headers") {
    for (const Include& include : includesUnder("app")) {
        const bool door =
            include.from.starts_with("app/gl/") || include.from.starts_with("app/render/");
        CAPTURE(include.from);
        if (!door) CHECK_FALSE(std::regex_search(include.target, std::regex(kGl)));
    }
}

TEST_CASE("The GL door knows nothing of rendering, and rendering nothing of panels or commands") {
    forbid("app/gl", "^app/(render|ui|cli|image_io|workbench)/");
    forbid("app/render", "^app/(ui|cli|workbench)/");
}
