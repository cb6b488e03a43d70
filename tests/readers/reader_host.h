// reader_host.h: the readers of this build, for the tests.
#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/dataset/dataset.h"
#include "core/plugin/plugin_host.h"
#include "tests/text.h"

inline const neph::PluginHost& readerHost() {
    static const neph::PluginHost host(
        std::vector<std::filesystem::path>{std::filesystem::path(NEPH_TEST_READER_DIR)});
    return host;
}

inline std::shared_ptr<neph::Dataset> openFiles(std::vector<std::filesystem::path> files) {
    return neph::Dataset::open(files, readerHost());
}

/// The parts of the Error that `work` throws; `what` is empty if it throws none.
template <typename Work>
neph::ErrorParts errorOf(Work&& work) {
    try {
        work();
    } catch (const neph::Error& error) {
        return error.parts();
    }
    return {};
}

/// The parts of the Error with which opening a file or folder fails.
inline neph::ErrorParts openError(const std::filesystem::path& path) {
    return errorOf([&] { openFiles({path}); });
}

/// Whether one of the notes contains `text`.
inline bool hasNote(const neph::DatasetInfo& info, std::string_view text) {
    for (const std::string& note : info.notes) {
        if (contains(note, text)) return true;
    }
    return false;
}
