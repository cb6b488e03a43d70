// info.h: `nephoscope info`: what a forecaster wants to know of a run before looking at it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace neph {

class Dataset;

struct InfoOptions {
    std::vector<std::filesystem::path>
        files;  ///< files of one series, or a folder; none: the bundled storm
    bool json = false;
};

/// Prints the summary; returns the exit code. Throws Error.
int runInfo(const InfoOptions& options);

/// The summary for people, and the same and more as JSON text.
std::string infoText(Dataset& dataset);
std::string infoJson(Dataset& dataset);

}  // namespace neph
