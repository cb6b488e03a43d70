// shader_source_test.cpp: shader errors name file and line, and a bad edit leaves the last good
// program in use.
#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/gl/program.h"
#include "app/gl/shader_source.h"
#include "core/base/error.h"
#include "tests/gpu/context.h"

using namespace neph;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("nephoscope-shaders-" + std::to_string(getpid()));
    Folder() { fs::create_directories(path / "lib"); }
    ~Folder() { fs::remove_all(path); }

    void write(const char* name, const std::string& text, int ageS = 0) const {
        std::ofstream(path / name) << text;
        fs::last_write_time(path / name,
                            fs::file_time_type::clock::now() - std::chrono::seconds(ageS));
    }
};

const std::string kGood =
    "#version 450 core\nlayout(local_size_x = 1) in;\n#include \"lib/helper.glsl\"\n"
    "void main() { helper(); }\n";
const std::string kHelper = "#pragma once\n\nfloat helper() { return 1.0; }\n";

std::string messageOf(const Folder& folder) {
    try {
        const gl::Program program(folder.path, "main.comp", {});
    } catch (const Error& error) {
        return error.message();
    }
    return "compiled";
}

}  // namespace

TEST_CASE("Includes are put in once and defines go below the version line") {
    const Folder folder;
    folder.write("main.comp",
                 "#version 450 core\n#include \"lib/helper.glsl\"\n#include "
                 "\"lib/helper.glsl\"\nvoid main() {}\n");
    folder.write("lib/helper.glsl", kHelper);
    const gl::ShaderSource source = gl::loadShader(folder.path, "main.comp", {"NOISE 1"});
    CHECK(source.text.starts_with("#version 450 core\n#define NOISE 1\n"));
    CHECK(source.text.find("helper()") == source.text.rfind("helper()"));
    CHECK(source.files.size() == 2);
}

TEST_CASE("An error in an included file is reported with that file's name and line") {
    neph::test::needContext();
    const Folder folder;
    folder.write("main.comp", kGood);
    folder.write("lib/helper.glsl", kHelper);
    CHECK(messageOf(folder) == "compiled");
    folder.write("lib/helper.glsl", "#pragma once\n\nfloat helper() { return missing; }\n");
    CHECK(messageOf(folder).find("helper.glsl:3") != std::string::npos);
    CHECK(messageOf(folder).find("missing") != std::string::npos);
    folder.write("main.comp", kGood + "\nnonsense\n");
    folder.write("lib/helper.glsl", kHelper);
    CHECK(messageOf(folder).find("main.comp:6") != std::string::npos);
}

TEST_CASE("A missing include is an error that names the line") {
    const Folder folder;
    folder.write("main.comp", "#version 450 core\n\n#include \"lib/none.glsl\"\n");
    try {
        gl::loadShader(folder.path, "main.comp", {});
        FAIL("must throw");
    } catch (const Error& error) {
        CHECK(error.message().find("main.comp:3") != std::string::npos);
        CHECK(error.message().find("lib/none.glsl") != std::string::npos);
    }
}

TEST_CASE("Two resources of a program that share a binding are reported by name") {
    neph::test::needContext();
    const Folder folder;
    const auto with = [&](const std::string& resources, const std::string& body) {
        folder.write("main.comp", "#version 450 core\nlayout(local_size_x = 1) in;\n" + resources +
                                      "\nvoid main() { " + body + " }\n");
        return messageOf(folder);
    };
    const std::string textures = "layout(binding = 1) uniform sampler2D t_list[2];\n";
    const std::string read = "layout(std430, binding = 3) buffer Out { vec4 sum; };\n";
    const std::string use =
        "sum = texture(t_list[0], vec2(0)) + texture(t_list[1], vec2(0)) + texture(t_b, vec2(0));";
    CHECK(with(read + textures + "layout(binding = 3) uniform sampler2D t_b;", use) == "compiled");
    const std::string shared =
        with(read + textures + "layout(binding = 2) uniform sampler2D t_b;", use);
    CHECK(shared.find("t_list") != std::string::npos);
    CHECK(shared.find("t_b") != std::string::npos);
    CHECK(shared.find("both 2") != std::string::npos);
    CHECK(with(read + "layout(std430, binding = 3) buffer In { vec4 part; };", "sum = part;")
              .find("both 3") != std::string::npos);
    CHECK(with("layout(rgba8, binding = 0) writeonly uniform image2D o_a;\n"
               "layout(rgba8, binding = 0) writeonly uniform image2D o_b;",
               "imageStore(o_a, ivec2(0), vec4(0)); imageStore(o_b, ivec2(0), vec4(0));")
              .find("both 0") != std::string::npos);
}

TEST_CASE(
    "A bad edit leaves the last good program, says so once, and the next good edit takes over") {
    neph::test::needContext();
    const Folder folder;
    folder.write("main.comp", kGood, 30);
    folder.write("lib/helper.glsl", kHelper, 30);
    gl::ProgramCache cache(folder.path);
    const gl::Program* first = &cache.get("main.comp");
    CHECK(cache.reload().empty());

    folder.write("lib/helper.glsl", "broken", 20);
    const auto problems = cache.reload();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].find("helper.glsl:1") != std::string::npos);
    CHECK(&cache.get("main.comp") == first);
    CHECK(cache.reload().empty());

    folder.write("lib/helper.glsl", kHelper, 10);
    CHECK(cache.reload().empty());
    CHECK(cache.generation() == 1);
}
