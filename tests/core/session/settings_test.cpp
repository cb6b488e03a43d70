// settings_test.cpp: what is remembered between runs, and a file of it that is wrong.
#include "core/session/settings.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/session/recent.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

Settings withMemory(const std::string& memory) {
    Settings settings;
    settings.memory = memory;
    return settings;
}

}  // namespace

TEST_CASE("Settings are remembered, and keys of other versions stay") {
    const TemporaryFolder folder;
    const Environment home("XDG_CONFIG_HOME", folder.path().string());
    std::vector<std::string> warnings;
    CHECK(loadSettings(warnings) == Settings{});
    saveSettings(withMemory("2GiB"));
    CHECK(loadSettings(warnings).memory == "2GiB");
    const auto file = folder / "nephoscope" / "settings.json";
    std::ofstream(folder / "nephoscope/settings.json")
        << R"({"type": "nephoscope-settings", "version": 1, "colour": "blue", "memory": "1GiB"})";
    saveSettings(withMemory("50%"));
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    CHECK(contains(text.str(), "blue"));
    CHECK(contains(text.str(), "50%"));
    CHECK(warnings.empty());
}

TEST_CASE("A file of settings that is wrong is told, not used and not overwritten") {
    const TemporaryFolder folder;
    const Environment home("XDG_CONFIG_HOME", folder.path().string());
    std::filesystem::create_directories(folder / "nephoscope");
    for (const char* text :
         {"{", "[]", R"({"type": "other"})", R"({"type": "nephoscope-settings", "version": 2})",
          R"({"type": "nephoscope-settings", "version": 1, "memory": 3})"}) {
        CAPTURE(text);
        std::ofstream(folder / "nephoscope/settings.json") << text;
        std::vector<std::string> warnings;
        CHECK(loadSettings(warnings) == Settings{});
        REQUIRE(warnings.size() == 1);
        CHECK(contains(warnings[0], "settings.json"));
    }
    std::ofstream(folder / "nephoscope/settings.json") << "{";
    CHECK_THROWS_AS(saveSettings(withMemory("1GiB")), Error);
}

TEST_CASE("Every setting reads back as it was saved") {
    const TemporaryFolder folder;
    const Environment home("XDG_CONFIG_HOME", folder.path().string());
    Settings settings;
    settings.memory = "50%";
    settings.theme = Theme::light;
    settings.textScale = 1.1f;
    settings.framesPerSecond = 60.5;
    settings.leftColumn = settings.rightColumn = false;
    settings.leftColumnEms = 22.5f;
    settings.rightColumnEms = 30.1f;
    settings.dataDetails = true;
    settings.window = WindowPlace{-40, 12, 1400, 800};  // on a screen to the left of the first
    settings.scaleBar = settings.compass = false;
    settings.heightRuler = true;
    settings.measureAtRest = false;
    settings.denoisedPreview = true;
    settings.recent = {"/data/a\n/data/b", "/data/Größe"};
    CHECK_FALSE(settingsWereSaved());
    saveSettings(settings);
    CHECK(settingsWereSaved());
    std::vector<std::string> warnings;
    CHECK(loadSettings(warnings) == settings);
    CHECK(warnings.empty());
    std::ostringstream text;
    text << std::ifstream(folder / "nephoscope/settings.json").rdbuf();
    CHECK(contains(text.str(), "\"text_scale\": 1.1,"));
}

TEST_CASE("A wrong setting is told with what is expected, and the others are used") {
    const TemporaryFolder folder;
    const Environment home("XDG_CONFIG_HOME", folder.path().string());
    std::filesystem::create_directories(folder / "nephoscope");
    struct Case {
        const char* key;
        const char* value;
        const char* expected;
    };
    for (const Case& c :
         {Case{"theme", "\"blue\"", "\"light\""}, Case{"text_scale", "100", "0.5 to 4"},
          Case{"text_scale", "\"1\"", "0.5 to 4"}, Case{"compass", "1", "true or false"},
          Case{"frames_per_second", "0", "1 to 240"}, Case{"recent", "[1]", "names"},
          Case{"denoised_preview", "\"on\"", "true or false"},
          Case{"left_column_letters", "4", "15 to 40"},
          Case{"right_column_letters", "true", "15 to 40"},
          Case{"window", "[0, 0, 1280]", "height"}, Case{"window", "[0, 0, 0, 720]", "height"},
          Case{"window", "\"large\"", "height"}, Case{"measure_at_rest", "1", "or null"},
          Case{"recent", "{}", "names"}}) {
        CAPTURE(c.key);
        CAPTURE(c.value);
        std::ofstream(folder / "nephoscope/settings.json")
            << R"({"type": "nephoscope-settings", "version": 1, "memory": "1GiB", ")" << c.key
            << "\": " << c.value << "}";
        std::vector<std::string> warnings;
        Settings expected;
        expected.memory = "1GiB";
        CHECK(loadSettings(warnings) == expected);
        REQUIRE(warnings.size() == 1);
        CHECK(contains(warnings[0], "settings.json"));
        CHECK(contains(warnings[0], c.key));
        CHECK(contains(warnings[0], c.expected));
    }
}

TEST_CASE("What was opened recently is listed newest first, once, and twelve at most") {
    std::vector<std::string> recent;
    for (int i = 0; i < 15; ++i) addRecent(recent, "/data/" + std::to_string(i));
    addRecent(recent, "/data/9");
    addRecent(recent, "");
    REQUIRE(recent.size() == kMaxRecent);
    CHECK(recent[0] == "/data/9");
    CHECK(recent[1] == "/data/14");
    CHECK(recent.back() == "/data/3");
}

TEST_CASE("Files opened together are one entry, and what is bundled is none") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.nc") << "x";
    std::ofstream(folder / "b.nc") << "x";
    const std::vector<std::string> named{(folder / "a.nc").string(),
                                         (folder / "x/../b.nc").string()};
    std::filesystem::create_directory(folder / "x");
    const std::string entry = recentEntry(named);
    CHECK(namesIn(entry) ==
          std::vector<std::string>{(folder / "a.nc").string(), (folder / "b.nc").string()});
    CHECK(labelOf(entry).name == "a.nc and 1 more");
    CHECK(labelOf(entry).folder == folder.path().string());
    CHECK(isThere(entry));
    std::filesystem::remove(folder / "b.nc");
    CHECK_FALSE(isThere(entry));
    CHECK(recentEntry(std::vector<std::string>{"cumulus"}).empty());
    CHECK(recentEntry({}).empty());
}
