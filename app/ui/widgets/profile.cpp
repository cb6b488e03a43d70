// profile.cpp: one profile after the other, so that rows neither vanish nor jump.
#include "app/ui/widgets/profile.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace neph::ui {
namespace {

/// New rows take the place of those of the same label; others go in behind the one that they
/// follow.
void merge(std::vector<ProfileRow>& shown, std::vector<ProfileRow> next) {
    for (ProfileRow& row : shown) {
        row.old = true;
        if (row.share > 0.0) row.note.clear();  // a share of another frame
        row.share = 0.0;
    }
    std::size_t at = 0;
    for (ProfileRow& row : next) {
        const auto same = std::find_if(shown.begin(), shown.end(), [&](const ProfileRow& known) {
            return known.label == row.label;
        });
        if (same != shown.end()) {
            at = static_cast<std::size_t>(same - shown.begin());
            *same = std::move(row);
        } else {
            shown.insert(shown.begin() + static_cast<std::ptrdiff_t>(at), std::move(row));
        }
        ++at;
    }
}

}  // namespace

void update(Profile& shown, Profile next, bool afterChange) {
    if (shown.engine == next.engine) {
        merge(shown.passes, std::move(next.passes));
        merge(shown.samples, std::move(next.samples));
        next.passes = std::move(shown.passes);
        next.samples = std::move(shown.samples);
        if (!afterChange) next.redone = std::move(shown.redone);
    }
    shown = std::move(next);
}

}  // namespace neph::ui
