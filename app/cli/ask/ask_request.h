// ask_request.h: what the commands that ask data have in common, and what each is asked.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/common/scene.h"
#include "core/analysis/figures.h"
#include "core/analysis/place.h"

namespace neph {

/// Which data, and which of their times.
struct AskedData {
    std::vector<std::string> files;  ///< files of one series, or a folder; none: the bundled storm
    std::vector<std::string> readers;
    std::string map;
    std::optional<TimeRange> times;
};

/// Files that a command writes: .svg, .png or .csv, of series also .nc.
struct AskedFiles {
    std::vector<std::filesystem::path> out;
    glm::ivec2 sizePx{0};  ///< of a plot; 0: its own
};

struct ProbeRequest {
    AskedData data;
    NamedPlace place;
    bool json = false;
};

struct ProfileRequest {
    AskedData data;
    NamedPlace place;
    ParcelSource source = ParcelSource::mixedLayer;
    AskedFiles files;
};

struct SectionRequest {
    AskedData data;
    std::optional<NamedPlace> from, to;  ///< of a vertical section
    std::optional<double> heightM;       ///< of a horizontal one
    Quantity shown = Quantity::condensate;
    std::vector<Quantity> contours;
    ColourLimits limits;
    AskedFiles files;
};

struct SeriesRequest {
    AskedData data;
    std::optional<SeriesKind> kind;  ///< none: all of them
    AskedFiles files;
};

}  // namespace neph
