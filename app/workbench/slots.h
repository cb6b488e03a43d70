// slots.h: the one or two slots of the workbench: which is edited, which are shown and where, and
// what keeps them together.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "app/ui/compare/compare_state.h"
#include "app/ui/compare/preview_label.h"
#include "app/ui/panel/layout.h"
#include "app/workbench/slot.h"
#include "core/grid/boxes.h"
#include "core/session/session_state.h"

namespace neph {

/// A slot's image, or the part of it that is left of the split or right of it.
struct ShownImage {
    Slot* slot = nullptr;
    PixelBox place;              ///< on the screen
    glm::vec2 widthShare{0, 1};  ///< from where to where of the whole image
};

class Slots {
  public:
    /// Makes a slot when one is wanted.
    using Make = std::function<std::unique_ptr<Slot>()>;
    Slots(ui::CompareState& compare, const Make& make);

    Slot& active() { return *slots_[static_cast<std::size_t>(compare_.active)]; }
    /// Nullptr while there is but one.
    Slot* other() { return slots_[compare_.active == 0 ? 1 : 0].get(); }
    /// The one on screen that the status line is about.
    Slot& seen();
    std::vector<Slot*> all();
    /// What is on the screen when the images' place is `place`.
    std::vector<ShownImage> shown(const PixelBox& place);

    /// Of A and B, where there are both.
    ui::PairState pair() const;

    /// Shows, hides and makes previews as they are `wanted`. Whether something else is on the
    /// screen.
    bool updatePreviews(bool wanted, ui::PreviewMarks& marks);
    /// Whether there is nothing to read, draw or denoise, and an error has its first figure.
    bool rest();

    /// Carries out what panels ask of `compare`. True when another slot is the active one.
    bool carryOut();
    /// Has the other slot follow camera and time of the active one, as far as they are linked.
    void link();

    SessionState state() const;
    /// Takes over documents and opens their data.
    void restore(const SessionState& state);

  private:
    void needSecond();
    void traceInB();

    ui::CompareState& compare_;
    Make make_;
    std::array<std::unique_ptr<Slot>, 2> slots_;
    int linkedTime_ = -1;  // of the active slot when the other last followed
    int linkedActive_ = 0;
};

}  // namespace neph
