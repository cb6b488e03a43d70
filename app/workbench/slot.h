// slot.h: one of the two sides that can be compared: data, look and camera, and the images drawn
// of them.
//
// Everything is on the main thread. While an image is drawn the panels are given a turn now and
// then, so that they follow the mouse however slow the image is.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/render/renderer.h"
#include "app/ui/compare/compare_errors.h"
#include "app/ui/compare/error_map.h"
#include "app/ui/panel/frame_report.h"
#include "app/ui/widgets/profile.h"
#include "app/workbench/denoised_preview.h"
#include "app/workbench/error_measurement.h"
#include "app/workbench/quality.h"
#include "core/base/resources.h"
#include "core/session/session.h"

namespace neph {

/// What decides how an image is drawn besides the document.
struct DrawRequest {
    glm::ivec2 placePx{1};    ///< of the image on the screen
    bool moving = false;      ///< the user holds it, or something moves by itself
    bool profile = false;     ///< with the time of each pass
    bool preview = false;     ///< drafts are to have what a preview is made of
    double frameMs = 1000.0;  ///< for a frame in motion, panels included
    /// Lets the panels have their turn where it is time, and returns the milliseconds that took.
    std::function<double()> panels;
    /// A refinement is to be left for what the user did meanwhile.
    std::function<bool()> yields;
};

class Slot {
  public:
    /// `data`: PluginHost or OpenSeries, as for Session.
    template <typename Data>
    Slot(Data data, const std::function<void()>& wake)
        : session(std::move(data), wake), preview_(wake) {
        renderer_.setWake(wake);
    }

    Session session;
    ui::FrameReport report;  ///< of the image that `texture` shows

    /// Takes in what was read since the last call, and hands it to the renderer.
    void takeData();
    /// Notices what was changed since the last call.
    void noteChanges();
    /// Draws the next image, if there is a better one than that shown. Returns whether it did;
    /// `profile` is brought up to date where it was asked for.
    bool draw(const DrawRequest& request, ui::Profile& profile);

    /// Asks for the error of the image that is there or in the making, or stops measuring it.
    void toggleError();
    bool wantsError() const { return wantsError_; }
    /// Whether it is being measured, or will be once the image is complete.
    bool measures() const { return wantsError_ || measurement_; }
    /// Whether there is an image that gets no better by itself, whose error is not known well.
    bool isMeasurable() const;
    /// A piece of work, which `progress` ends; `report` gets what comes of it.
    void measureError(const Progress& progress);
    /// Gives up what is not measured yet, and its memory.
    void stopMeasuring();
    std::shared_ptr<const ui::ErrorMap> errorMap() const { return errorMap_; }

    /// Whether its engine has the halves that a preview is made of.
    bool canPreview() const { return traitsOf(session.document.look.engine).layers; }
    /// Begins to denoise the image, shows what was denoised, or hides it where it is not `wanted`.
    /// Whether something else is on the screen. May be called while an image is drawn.
    bool updatePreview(bool wanted);
    bool denoises() const { return preview_.busy(); }

    void reloadShaders();
    void redraw() { drawn_.reset(); }
    void measuredPanels(double milliseconds) {
        for (ui::QualityControl& quality : qualities_) quality.measuredPanels(milliseconds);
    }

    /// What the screen shows, and its size; all else is of the image as it was drawn.
    unsigned texture() const { return renderer_.displayTexture(); }
    glm::ivec2 textureSizePx() const { return renderer_.displaySizePx(); }
    /// Counts the images; one that has but other tones is none.
    std::uint64_t images() const { return images_; }
    /// Whether frames are added until the error is small enough.
    bool converges() const {
        return traitsOf(session.document.look.engine).refinement == Refinement::converges;
    }
    /// Whether the image is of the document, and in full.
    bool whole() const { return drawn_ && drawn_->step == ui::kFullStep; }
    /// The image in linear light, and its halves where the engine has them.
    ImageF linear() const { return renderer_.readLinear(); }
    ui::LinearHalves halves() const { return renderer_.readHalves(); }
    bool changedSinceLastLook() const { return session.document != seen_; }
    /// Whether there is an image still to be drawn: at once, or after some rest.
    enum class Waiting { no, rest, now };
    Waiting waiting(bool moving) const;
    double restS() const;

  private:
    render::FrameInputs inputsOf(const ui::Draft& draft, const DrawRequest& request) const;
    bool averages(bool moving) const;
    bool addsPaths(bool moving) const;
    ui::QualityControl& qualityOf(Engine engine) {
        return qualities_.at(static_cast<std::size_t>(engine));
    }
    std::optional<ui::Draft> next(const DrawRequest& request);
    void beginToPreview();
    void beginToMeasure();
    void forgetError();
    void tell(const ui::Draft& drawn, const ParameterSet& of, int time,
              const render::FrameStats& stats);
    std::optional<render::FrameStats> render(const ui::Draft& draft,
                                             const render::FrameInputs& inputs,
                                             const DrawRequest& request);

    render::Renderer renderer_{resourcePath("shaders")};
    std::array<ui::QualityControl, kEngineCount> qualities_ = ui::qualityOfEachEngine();
    Document seen_;                 // as of the last look
    double seenVisibilityM_ = 0.0;  ///< by the look and the air of the data
    glm::ivec2 placePx_{0};
    render::Accumulation image_;
    std::optional<ui::Draft> drawn_;  // none: to be drawn again
    bool retone_ = false;             // what is drawn is good but for its tones
    std::uint64_t images_ = 0;
    std::optional<ErrorMeasurement> measurement_;   // of the image on screen
    std::shared_ptr<const ui::ErrorMap> errorMap_;  // likewise
    bool wantsError_ = false;
    DenoisedPreview preview_;
    render::FrameInputs previewOf_;   // that is being made
    std::uint64_t unmeasurable_ = 0;  // the image that cannot be compared with the reference
    std::chrono::steady_clock::time_point changed_ = std::chrono::steady_clock::now();
};

}  // namespace neph
