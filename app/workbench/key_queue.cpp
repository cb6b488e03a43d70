// key_queue.cpp: where a frame's worth ends.
#include "app/workbench/key_queue.h"

#include <algorithm>

namespace neph {
namespace {

/// Whether a frame that has been given `batch` can tell it from `next`.
bool fits(const std::vector<KeyEvent>& batch, const KeyEvent& next) {
    using enum KeyEvent::Kind;
    const bool edits = next.kind == down && next.edits;
    for (const KeyEvent& event : batch) {
        // A command may give the letters after it another meaning.
        if (event.kind == down && event.edits) {
            return next.kind == up && next.key != event.key;
        }
        const bool same = event.kind != letter && next.kind != letter && event.key == next.key;
        if (same && !(event.kind == down && next.kind == down)) return false;
        if (edits && event.kind == letter) return false;
    }
    return true;
}

}  // namespace

std::vector<KeyEvent> KeyQueue::take(std::uint64_t until) {
    std::vector<KeyEvent> batch;
    while (!events_.empty() && events_.front().order < until && fits(batch, events_.front())) {
        batch.push_back(events_.front());
        events_.pop_front();
    }
    return batch;
}

}  // namespace neph
