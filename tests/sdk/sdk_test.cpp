// sdk_test.cpp: installs Nephoscope into a folder, builds the example reader against only that
// installation, and lets the installed program use it, as docs/write-a-reader.md describes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/cli/program.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

namespace {

namespace fs = std::filesystem;

const fs::path kExample = NEPH_TEST_SOURCE_DIR "/examples/reader";

/// Runs a shell command in `folder`, without the readers and the display of the person who tests.
Outcome run(const fs::path& folder, const std::string& command) {
    const std::string line = "cd '" + folder.string() +
                             "' && env -u DISPLAY -u WAYLAND_DISPLAY -u NEPHOSCOPE_DATA_DIR -u "
                             "NEPHOSCOPE_READER_PATH XDG_DATA_HOME=\"$PWD/data\" sh -c '" +
                             command + "' >out 2>err";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readText(folder / "out"),
            readText(folder / "err")};
}

/// A folder with the installation in usr/, the built example in build/, and data to read.
struct Workshop {
    TemporaryFolder folder;

    Workshop() {
        require("\"" NEPH_TEST_CMAKE "\" --install \"" NEPH_TEST_BUILD_DIR "\" --prefix usr");
        fs::copy(kExample, folder.path());
        // Default compiler and flags, because plugins are not built like the program, but the build
        // tool of this build: CMake's own choice is make, which may be missing.
        require("\"" NEPH_TEST_CMAKE "\" -G \"" NEPH_TEST_GENERATOR
                "\" -S . -B build -DCMAKE_PREFIX_PATH=\"$PWD/usr\"");
        require("\"" NEPH_TEST_CMAKE "\" --build build");
        REQUIRE(fs::exists(folder / "build/fog.so"));
        // A small version of what make_fog.py writes.
        std::ofstream data(folder / "bank.fog", std::ios::binary);
        data << "FOG 2 2 3 100 100 50\n";
        for (const float gramPerKg :
             {0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.25f, 0.f, 0.f, 0.f, 0.f, 0.f}) {
            data.write(reinterpret_cast<const char*>(&gramPerKg), sizeof gramPerKg);
        }
    }
    void require(const std::string& command) const {
        const Outcome outcome = run(folder.path(), command);
        CAPTURE(command);
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
    }
};

const Workshop& workshop() {
    static const Workshop made;
    return made;
}

Outcome nephoscope(const std::string& arguments, const std::string& environment = "") {
    return run(workshop().folder.path(), environment + " usr/bin/nephoscope " + arguments);
}

/// The first fenced block of `language` in a Markdown page.
std::string block(const std::string& page, const std::string& language) {
    const std::string fence = "```" + language + "\n";
    const std::size_t start = page.find(fence);
    if (start == std::string::npos) return {};
    const std::size_t from = start + fence.size();
    return page.substr(from, page.find("```", from) - from);
}

}  // namespace

TEST_CASE("The installed program finds its own readers and data, whatever the prefix") {
    const Outcome readers = nephoscope("readers");
    CHECK(readers.status == 0);
    const fs::path own = fs::canonical(workshop().folder / "usr/lib/nephoscope/readers");
    CHECK(contains(readers.out, (own / "wrf_netcdf.so").string()));
    CHECK(!contains(readers.out, "Rejected"));
    const Outcome info = nephoscope("info");  // describes the installed sample
    CHECK(info.status == 0);
    CHECK(contains(info.out, "WRF V4.2.2"));
}

TEST_CASE("An external reader is found by its path, the path variable or the user's data folder") {
    const auto reads = [](const Outcome& outcome) {
        CAPTURE(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(contains(outcome.out, "Fog 1"));
        CHECK(contains(outcome.out, "2 x 2 x 3 cells of 100 m"));
        CHECK(contains(outcome.out, "base 0.05 km, top 0.10 km"));
        CHECK(contains(outcome.out, "0.25"));
    };
    CHECK(contains(nephoscope("info bank.fog").err, "no reader knows this format"));
    reads(nephoscope("info --reader build/fog.so bank.fog"));
    reads(nephoscope("info bank.fog", "NEPHOSCOPE_READER_PATH=build/fog.so"));
    const fs::path home = workshop().folder / "data/nephoscope/readers";
    fs::create_directories(home);
    fs::copy(workshop().folder / "build/fog.so", home);
    reads(nephoscope("info bank.fog"));
    CHECK(contains(nephoscope("readers").out, (home / "fog.so").string()));
    fs::remove_all(home);
}

TEST_CASE("Naming a file that is not a reader is an error with the reason") {
    const Outcome none = nephoscope("info --reader bank.fog bank.fog");
    CHECK(none.status == 1);
    CHECK(contains(none.err, "cannot be used as a reader"));
    CHECK(contains(nephoscope("readers --reader nowhere.so").err, "there is no such reader"));
}

TEST_CASE("Errors that the example throws reach the user") {
    std::ofstream(workshop().folder / "short.fog") << "FOG 2 2 3 100 100 50\n";
    const Outcome outcome = nephoscope("info --reader build/fog.so short.fog");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.err, "cloud ends early"));
    CHECK(contains(outcome.err, "4 bytes per cell"));
    std::ofstream(workshop().folder / "lie.fog") << "FOG -2 2 3 100 100 50\n";
    CHECK(contains(nephoscope("info --reader build/fog.so lie.fog").err, "size -2 x 2 x 3"));
}

TEST_CASE("The component sdk consists of the headers and the CMake package") {
    const TemporaryFolder folder;
    const Outcome outcome =
        run(folder.path(), "\"" NEPH_TEST_CMAKE "\" --install \"" NEPH_TEST_BUILD_DIR
                           "\" --component sdk --prefix usr");
    CHECK(outcome.status == 0);
    CHECK(fs::exists(folder / "usr/include/nephoscope/reader_abi.h"));
    CHECK(fs::exists(folder / "usr/lib/cmake/nephoscope/nephoscopeConfig.cmake"));
    CHECK(!fs::exists(folder / "usr/bin"));
}

TEST_CASE("docs/write-a-reader.md shows the example unchanged, in 60 lines at most") {
    const std::string page = readText(NEPH_TEST_SOURCE_DIR "/docs/write-a-reader.md");
    const std::string source = readText(kExample / "fog_reader.cpp");
    CHECK(block(page, "cpp") == source);
    CHECK(block(page, "cmake") == readText(kExample / "CMakeLists.txt"));
    CHECK(block(page, "python") == readText(kExample / "make_fog.py"));
    CHECK(std::count(source.begin(), source.end(), '\n') <= 60);
}
