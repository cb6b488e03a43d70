// bench_command.h: `nephoscope bench`: what it takes to open data, to draw the modes of [Riley03]
// table 4, to follow a change, to grow, and to follow the hand.
#pragma once
#include <string>
#include <vector>

namespace neph {

struct BenchOptions {
    std::vector<std::string> files;    ///< none: the bundled storm
    std::vector<std::string> readers;  ///< libraries or folders, before those found elsewhere
    /// Of modes, changes, growth, window, reference.
    std::vector<std::string> sections{"modes", "changes"};
    std::vector<std::string> sizes;         ///< WxH; none: each section's own
    std::vector<std::string> grids{"128"};  ///< N or XxYxZ cells
    std::string engine = "all";             ///< one of benchEngines()
    int steps = 128;        ///< or slices, along the diagonal of what is occupied; [Riley03] §5
    int frames = 12;        ///< measured of each row, evenly round the storm
    int growthTo = 256;     ///< cells along the longest side of the largest grid of `growth`
    std::string json;       ///< file for the result; empty: stdout
    bool openOnly = false;  ///< opening and the first picture alone
};

/// "all", and the engines of which one frame is an image.
std::vector<std::string> benchEngines();

/// Tables on stderr, JSON to the file or stdout. Returns 0; throws Error or UsageError.
int runBench(const BenchOptions& options);

}  // namespace neph
