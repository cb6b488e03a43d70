// scene_arguments.cpp: names and help of what several commands take.
#include "app/cli/common/scene_arguments.h"

namespace neph {

void addReaderOption(CLI::App& command, std::vector<std::string>& readers) {
    command.add_option("--reader", readers, "Reader plugin to use; may be repeated")
        ->type_name("LIBRARY|FOLDER")
        ->allow_extra_args(false);  // what follows is a file
}

void addMemoryOption(CLI::App& command, std::string& memory) {
    command.add_option("--memory", memory, "For fields: 2GiB, 512MiB or 50% of the free")
        ->type_name("SIZE|SHARE");
}

void addSceneOptions(CLI::App& command, SceneOptions& options) {
    command.add_option("FILE", options.files,
                       "Files of one series, or a folder; none: the bundled storm");
    command.add_option("--preset", options.preset, "Preset, by name or file")
        ->type_name("NAME|FILE");
    command
        .add_option("--parts", options.parts, "Of the preset: fields,light,view,camera; else all")
        ->type_name("LIST");
    command.add_option("--set", options.assignments, "Set one parameter; may be repeated")
        ->type_name("ID=VALUE")
        ->allow_extra_args(false);
    command.add_option("--camera", options.camera, "Camera of a preset, or a file with one")
        ->type_name("NAME|FILE");
    command.add_option("--time", options.time, "Time index, a:b or all; else the middle one")
        ->type_name("INDEX|a:b|all");
    command.add_option("--region", options.region, "Part of the domain in km; else all of it")
        ->type_name("x0:x1,y0:y1[,z0:z1]");
    addMemoryOption(command, options.memory);
    addReaderOption(command, options.readers);
}

void addViewOptions(CLI::App& command, std::string& observer, std::string& view) {
    command.add_option("--observer", observer, "Look from a place; km, km, m, then degrees")
        ->type_name("EAST,NORTH,HEIGHT,AZIMUTH,ELEVATION[,FOV]");
    command.add_option("--view", view, "Look from a side, all clouds in the picture")
        ->type_name("fit|plan|north|east|south|west|below");
}

}  // namespace neph
