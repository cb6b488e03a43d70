// moved_data.cpp: finds out one move and tries it for all missing files.
#include "core/session/moved_data.h"

#include <algorithm>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/dataset/file_list.h"
#include "core/dataset/member_list.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

/// A name is missing if opening it would fail; names of bundled samples are not.
bool isMissing(const std::string& name, bool run) {
    try {
        run ? filesOfRun(name) : listFiles(std::span(&name, 1));
        return false;
    } catch (const Error&) {
        return true;
    }
}

/// `path` after moving `from` to `to`; empty if it is not under `from`.
std::optional<fs::path> moved(const fs::path& path, const fs::path& from, const fs::path& to) {
    const auto [end, rest] = std::mismatch(from.begin(), from.end(), path.begin(), path.end());
    if (end != from.end()) return {};
    fs::path there = to;
    for (auto part = rest; part != path.end(); ++part) there /= *part;
    return there;
}

void replace(SessionState& state, const std::string& name, const std::string& by) {
    for (SlotState& slot : state.slots) std::ranges::replace(slot.data, name, by);
}

}  // namespace

std::vector<std::string> missingData(const SessionState& state) {
    std::vector<std::string> missing;
    for (const SlotState& slot : state.slots) {
        for (const std::string& name : slot.data) {
            const bool known = std::ranges::find(missing, name) != missing.end();
            if (!known && isMissing(name, slot.members)) missing.push_back(name);
        }
    }
    return missing;
}

int moveData(SessionState& state, const std::string& missing, const fs::path& found) {
    std::error_code error;
    fs::path from = missing, to = fs::absolute(found).lexically_normal();
    if (!to.has_filename()) to = to.parent_path();
    const fs::path inside = to / from.filename();
    if (fs::is_directory(to, error) && fs::exists(inside, error)) to = inside;
    if (!fs::exists(to, error)) return 0;
    replace(state, missing, to.string());
    int count = 1;
    // The part that both paths end with has not moved; what comes before it has.
    while (from.has_relative_path() && to.has_relative_path() && from.filename() == to.filename()) {
        from = from.parent_path();
        to = to.parent_path();
    }
    for (const std::string& name : missingData(state)) {
        const auto there = moved(name, from, to);
        if (!there || !fs::exists(*there, error)) continue;
        replace(state, name, there->string());
        ++count;
    }
    return count;
}

}  // namespace neph
