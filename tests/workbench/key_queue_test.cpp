// key_queue_test.cpp: what fast typing on slow frames becomes.
#include "app/workbench/key_queue.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace neph;

namespace {

constexpr auto kAll = std::numeric_limits<std::uint64_t>::max();
constexpr int kBackspace = 8;

class Typist {
  public:
    KeyQueue queue;

    void press(int key, bool edits) {
        add({KeyEvent::Kind::down, key, 0, 0, 0, edits, 0});
        if (!edits)
            add({KeyEvent::Kind::letter, 0, 0, 0, static_cast<std::uint32_t>(key), false, 0});
        add({KeyEvent::Kind::up, key, 0, 0, 0, edits, 0});
    }
    void type(const std::string& words) {
        for (const char c : words) press(c, false);
    }

  private:
    void add(KeyEvent event) {
        event.order = ++order_;
        queue.add(event);
    }
    std::uint64_t order_ = 0;
};

/// A line of text as ImGui edits it: once a frame, keys before letters.
struct Line {
    std::string text;
    int frames = 0;
    void play(KeyQueue& queue) {
        std::vector<int> down;
        while (!queue.empty()) {
            ++frames;
            bool backspace = false;
            std::string letters;
            for (const KeyEvent& event : queue.take(kAll)) {
                const bool held = std::ranges::find(down, event.key) != down.end();
                if (event.kind == KeyEvent::Kind::letter)
                    letters += static_cast<char>(event.letter);
                if (event.kind == KeyEvent::Kind::down && !held) {
                    down.push_back(event.key);
                    backspace = backspace || event.key == kBackspace;
                }
                if (event.kind == KeyEvent::Kind::up) std::erase(down, event.key);
            }
            if (backspace && !text.empty()) text.pop_back();
            text += letters;
            REQUIRE(frames < 1000);
        }
    }
};

}  // namespace

TEST_CASE("Ten presses of Backspace between two frames remove ten letters") {
    Typist typist;
    for (int i = 0; i < 10; ++i) typist.press(kBackspace, true);
    Line line{"0123456789abc"};
    line.play(typist.queue);
    CHECK(line.text == "012");
}

TEST_CASE("Letters and editing keys keep their order") {
    Typist typist;
    typist.type("ligt");
    typist.press(kBackspace, true);
    typist.type("ht theme");
    Line line;
    line.play(typist.queue);
    CHECK(line.text == "light theme");
}

TEST_CASE("Different letters come in few frames, the same twice in two") {
    Typist typist;
    typist.type("abcdefgh");
    Line line;
    line.play(typist.queue);
    CHECK(line.text == "abcdefgh");
    CHECK(line.frames <= 16);
    typist.type("ee");
    line.play(typist.queue);
    CHECK(line.text == "abcdefghee");
}

TEST_CASE("A command ends the frame's worth, and what came later waits") {
    Typist typist;
    typist.press('p', true);
    typist.type("li");
    const auto first = typist.queue.take(kAll);
    REQUIRE(first.size() == 1);
    CHECK(first[0].edits);
    Typist other;
    other.type("ab");
    CHECK(other.queue.take(1).empty());
    CHECK_FALSE(other.queue.empty());
}
