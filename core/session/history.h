// history.h: undo and redo of the document, one step per gesture.
//
// The document is plain values, so a step is a copy of it. Panels change the document freely;
// `commit` at the end of a gesture makes one step of all changes since the last.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/camera/camera.h"
#include "core/camera/camera_path.h"
#include "core/look/parameter.h"
#include "core/session/pin.h"

namespace neph {

/// Everything about the image that the user can change: look, sampling and what follows.
struct Document : ParameterSet {
    CameraPose camera;
    int time = 0;    ///< index into the times of the data set
    int member = 0;  ///< of an ensemble, or kMeanMember
    std::vector<Bookmark> bookmarks;
    CameraPath path;
    std::vector<Pin> pins;
    bool operator==(const Document&) const = default;
};

/// Describes the change: "Cloud: Mixing scale 1 -> 0.5", "Cloud: 3 parameters", "Time 1 -> 2,
/// camera"; empty if equal. Times count from 1.
std::string describeChange(const Document& before, const Document& after);

/// The undo steps of one document.
class History {
  public:
    explicit History(const Document& start = {}) : last_(start) {}

    /// Discards all steps and starts at `document`, as after opening other data.
    void restart(const Document& document);

    /// Applies `change` to the states of all steps, for example when the times or the grid that
    /// they refer to have changed.
    void adapt(const std::function<void(Document&)>& change);

    /// Makes a step of the changes since the last commit, if any. `label` overrides describeChange.
    void commit(const Document& document, std::string label = {});

    /// Commits when a gesture is over: when the mouse button is released, or, after keys or the
    /// wheel, when nothing has changed for kRestS seconds.
    void settle(const Document& document, bool handDown, double restS);
    static constexpr double kRestS = 0.4;  // tuned by hand: more than between wheel clicks

    /// Labels of all steps, oldest first, those that were undone last.
    std::vector<std::string> steps() const;
    /// How many of them lead to the current state.
    std::size_t position() const { return past_.size(); }

    bool canUndo() const { return !past_.empty(); }
    bool canRedo() const { return !future_.empty(); }
    std::string undoLabel() const { return canUndo() ? past_.back().label : std::string(); }
    std::string redoLabel() const { return canRedo() ? future_.back().label : std::string(); }

    /// Goes one step back or forward in `document`; pending changes are committed first. False if
    /// there is no such step.
    bool undo(Document& document);
    bool redo(Document& document);
    /// Goes to the state after the first `steps` steps; pending changes are committed first. False
    /// if that is the current state or there are fewer steps.
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
