// script.h: recorded input: a text file of commands that is played into the window, for tests,
// demonstrations and the images of the documentation.
//
// One command a line; '#' opens a comment. PLACE is a name of app/ui/widgets/places.h or "x,y" in
// shares of the window; "image" is where the image is.
//   wait                     until data are read, the image is whole, exports are done and an error
//   that is
//                            being measured has its first figure
//   frames N                 so many frames
//   size WxH                 of the window
//   action ID                carries out an action
//   key CHORD                "Ctrl+Shift+S", as the menus have it
//   text WORDS               types
//   move PLACE               the mouse
//   click|right|double PLACE
//   drag PLACE X0 X1         along its width, in shares of it
//   pull PLACE DX DY         left drag from a place, in shares of the window
//   orbit DX DY              left drag on the image, in shares of the window
//   wheel PLACE NOTCHES
//   open FILE...             as dropped on the window
//   set ID=VALUE             a parameter of the look
//   expect ID=VALUE          fails where it is another
//   expect-place PLACE       fails where there is none
//   expect-file FILE         fails where there is none, or an empty one
//   expect-time INDEX
//   expect-member NAME       of an ensemble, or mean
//   screenshot FILE.png      of the window
//   monkey EVENTS SEED       random mouse, wheel, keys and text
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace neph {

enum class ScriptCommand {
    wait,
    frames,
    size,
    action,
    key,
    text,
    move,
    click,
    rightClick,
    doubleClick,
    drag,
    pull,
    orbit,
    wheel,
    open,
    set,
    expect,
    expectPlace,
    expectFile,
    expectTime,
    expectMember,
    screenshot,
    monkey
};

struct ScriptStep {
    ScriptCommand command = ScriptCommand::wait;
    std::vector<std::string> words;
    int line = 0;
};

/// Throws Error that names file and line.
std::vector<ScriptStep> parseScript(std::string_view text, const std::string& where);
std::vector<ScriptStep> loadScript(const std::filesystem::path& file);

}  // namespace neph
