// read_everything.h: reads a path as the host does, with the reader linked into this fuzz target:
// score, description, then a box of every variable at the first and the last time.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/plugin/plugin_file.h"

namespace fuzz {

/// Throws neph::Error where the host would.
inline void readEverything(const std::filesystem::path& path) {
    const NephReader& calls = *nephReader(NEPH_READER_ABI_VERSION);
    const int score = calls.score(path.c_str());
    if (score < 0 || score > 100) std::abort();
    if (score == 0) return;
    neph::PluginFile file(calls, calls.id, path);
    const neph::DatasetInfo& description = file.description();
    for (std::size_t v = 0; v < description.variables.size(); ++v) {
        // Boxes are small, to keep reads quick.
        const glm::ivec3 size = description.variables[v].size;
        const glm::ivec3 upper = glm::min(size, glm::ivec3(40));
        const glm::ivec3 lower = upper / 3;
        const glm::ivec3 box = upper - lower;
        std::vector<float> buffer(static_cast<std::size_t>(box.x) *
                                      static_cast<std::size_t>(box.y) *
                                      static_cast<std::size_t>(box.z) +
                                  neph::PluginFile::kGuardValues);
        for (const std::size_t time : {std::size_t{0}, description.times.size() - 1}) {
            try {
                file.read(v, time, {lower, upper}, buffer, {});
            } catch (const neph::Error&) {  // the next one may be readable
            }
        }
    }
}

}  // namespace fuzz
