// key_queue.h: keys and letters in the order in which they came, a frame's worth at a time.
//
// ImGui looks at keys once per frame: of a key that goes down twice between two frames it would see
// one press, and it takes letters and editing keys of one frame in an order of its own. So each
// frame gets what it can tell apart, and the rest waits for the next.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

namespace neph {

struct KeyEvent {
    enum class Kind : int { down, up, letter };
    Kind kind = Kind::down;
    int key = 0, scancode = 0, mods = 0;  ///< as the window system has them
    std::uint32_t letter = 0;             ///< code point
    bool edits = false;                   ///< moves or removes in text, or is a command's
    std::uint64_t order = 0;              ///< among all input
};

class KeyQueue {
  public:
    void add(const KeyEvent& event) { events_.push_back(event); }
    bool empty() const { return events_.empty(); }

    /// What the next frame can take, of events before `until`, and removes it.
    std::vector<KeyEvent> take(std::uint64_t until);
    /// Order of the first event. There is one.
    std::uint64_t firstOrder() const { return events_.front().order; }

  private:
    std::deque<KeyEvent> events_;
};

}  // namespace neph
