// program.h: runs the program as a user does and catches what it says.
#pragma once
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/temporary_folder.h"
#include "tests/text.h"

struct Outcome {
    int status = -1;
    std::string out, err;
};

inline std::string readText(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Images of these tests are about other things than light, whose solution takes seconds.
inline std::string withQuickLight(std::string arguments) {
    const std::string render = "render ";
    const bool says = arguments.find("view.light_voxels") != std::string::npos;
    if (says || !arguments.starts_with(render)) return arguments;
    return arguments.insert(render.size(), "--set view.light_voxels=1000 ");
}

/// `arguments` as typed in a shell; without a display, and with a home of its own, so that neither
/// the tester's presets nor screen play a part; `home` where several runs share one.
inline Outcome runProgram(const std::string& arguments, std::string home = {}) {
    const TemporaryFolder folder;
    if (home.empty()) home = folder.path().string();
    const std::string command = "cd '" + folder.path().string() +
                                "' && env -u DISPLAY -u WAYLAND_DISPLAY -u NEPHOSCOPE_DATA_DIR "
                                "XDG_DATA_HOME='" +
                                home + "' XDG_CONFIG_HOME=\"$PWD\" '" NEPH_TEST_PROGRAM "' " +
                                withQuickLight(arguments) + " >out 2>err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readText(folder / "out"),
            readText(folder / "err")};
}
