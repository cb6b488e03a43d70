// history.h: undo and redo of the document, one step per gesture.
//
// The document is plain values, so a step is a copy of them. Panels change the document freely;
// `commit` at the end of a gesture makes one step of whatever changed since the last.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/camera/camera.h"
#include "core/camera/camera_path.h"
#include "core/look/parameter.h"

namespace neph {

/// Everything about the image that the user can change: look, sampling and what follows.
struct Document : ParameterSet {
    CameraPose camera;
    int time = 0;  ///< index into the times of the data set
    std::vector<Bookmark> bookmarks;
    CameraPath path;
    bool operator==(const Document&) const = default;
};

/// What changed, in words: "Cloud: Mixing scale 1 -> 0.5", "Cloud: 3 parameters", "Time 1 -> 2,
/// camera"; empty when equal. Times count from 1.
std::string describeChange(const Document& before, const Document& after);

class History {
  public:
    explicit History(const Document& start = {}) : last_(start) {}

    /// Forgets all steps and starts at `document`, as after opening other data.
    void restart(const Document& document);

    /// Changes every state that steps lead to, as when the times or the grid that they count in are
    /// others.
    void adapt(const std::function<void(Document&)>& change);

    /// Makes a step of what changed since the last commit; nothing when nothing did. `label`
    /// overrides the words of describeChange.
    void commit(const Document& document, std::string label = {});

    /// Commits when a gesture is over: when the hand lets go (a mouse button that was down is up),
    /// or without a hand, as after keys or the wheel, when nothing has changed for kRestS seconds.
    void settle(const Document& document, bool handDown, double restS);
    static constexpr double kRestS = 0.4;  // tuned by hand: between two turns of a wheel

    /// Words for every step, oldest first, those that were undone at the end.
    std::vector<std::string> steps() const;
    /// How many of them lead to the present state.
    std::size_t position() const { return past_.size(); }

    bool canUndo() const { return !past_.empty(); }
    bool canRedo() const { return !future_.empty(); }
    std::string undoLabel() const { return canUndo() ? past_.back().label : std::string(); }
    std::string redoLabel() const { return canRedo() ? future_.back().label : std::string(); }

    /// Goes one step back or forth in `document`; what is not yet committed is committed first.
    /// False when there is no step.
    bool undo(Document& document);
    bool redo(Document& document);
    /// To the state after the first `steps` steps; what is not yet committed is committed first.
    /// False when it is the present one or there are not so many.
    bool jumpTo(Document& document, std::size_t steps);

  private:
    struct Step {
        Document before, after;
        std::string label;
    };
    static constexpr std::size_t kMaxSteps = 500;  // a step is about 1 KiB

    std::vector<Step> past_, future_;
    Document last_;
    bool handDown_ = false;
};

}  // namespace neph
