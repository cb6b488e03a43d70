// render_sides.h: the one scene of an image, or the two that share it: from what was asked for and
// what a session keeps to data that are open and a renderer that holds a time of them.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/render/render_request.h"
#include "app/cli/render/shots.h"
#include "app/image_io/metadata.h"
#include "app/render/renderer.h"
#include "core/dataset/dataset.h"
#include "core/look/haze.h"
#include "core/look/sun.h"
#include "core/session/session_state.h"
#include "core/volume/held_volume.h"

namespace neph {

/// What is to be seen, before anything is opened.
struct SideScene {
    SceneRequest request;  ///< with what the session says where nothing was typed
    Scene scene;
    std::optional<int> time;  ///< of the session
    bool ownCamera = false;   ///< else B is seen from where A is
};

/// A, and B where the request wants it. Throws Error or UsageError.
std::vector<SideScene> sideScenes(const RenderRequest& request,
                                  const std::optional<SessionState>& session);

/// Throws UsageError where an option acts with none of `engines`; samples are of those in
/// `sampled`. All are bits.
void checkActing(const RenderRequest& request, unsigned engines, unsigned sampled);

/// Data that are open, and the time of them that the renderer holds.
class Side {
  public:
    /// Needs a current GL context. `budget` bounds the volume.
    Side(SideScene what, const MemoryBudget& budget, const Progress& progress);

    /// Has the renderer hold a time. Throws Error or Cancelled.
    void show(int time, const Progress& progress);
    /// Notes of what is shown that were not told before.
    std::vector<std::string> newNotes();

    /// As typed, as the session says, or the default one; none but those there are.
    std::vector<int> times() const;
    const ParameterSet& parameters() const { return what_.scene.document; }
    /// The look that is drawn of the time that is shown.
    Look drawnLook() const { return lookAsDrawn(parameters().look, shown_.where); }
    const SideScene& what() const { return what_; }
    const DatasetInfo& info() const { return dataset_->info(); }
    const VolumeSummary& shown() const { return shown_; }
    /// Of an ensemble: "mem03" or "mean"; empty of a single run.
    std::string memberName() const;
    render::Renderer& renderer() { return *renderer_; }
    /// Whether such an image of what is shown is to scale, in words.
    std::string scaleOf(const Look& look) const;
    /// How an image with these parameters was made, for its file.
    Metadata describe(const ParameterSet& drawn, const CameraPose& pose,
                      const std::string& work) const;

  private:
    SideScene what_;
    std::shared_ptr<Dataset> dataset_;
    VolumeRequest request_;
    std::unique_ptr<render::Renderer> renderer_;
    VolumeSummary shown_;
    int time_ = -1;  // that the renderer holds
    std::vector<std::string> notes_, told_;
};

}  // namespace neph
