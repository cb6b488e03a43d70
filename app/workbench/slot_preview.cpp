// slot_preview.cpp: the denoised preview of a slot's image, which is on the screen alone.
#include <utility>

#include "app/workbench/slot.h"
#include "core/look/haze.h"

namespace neph {

/// There is nothing to begin with while the first paths of an image are traced.
void Slot::beginToPreview() {
    const auto now = DenoisedPreview::Clock::now();
    const bool full = drawn_->step == ui::kFullStep;
    const TracedImage traced{drawn_->sizePx, drawn_->sample + 1, full && !addsPaths(false)};
    if (!preview_.wants(traced, now)) return;
    std::array<ImageF, 2> halves = renderer_.readHalves();
    if (halves[0].pixels.empty()) return;
    DrawRequest request;
    request.placePx = placePx_;
    previewOf_ = inputsOf(*drawn_, request);
    preview_.start(std::move(halves), traced, now);
}

bool Slot::updatePreview(bool wanted) {
    if (!wanted) {
        preview_.forget();
        if (!renderer_.showsPreview()) return false;
        renderer_.hidePreview();
        report.previewSamples = 0;
        return true;
    }
    if (!canPreview() || changedSinceLastLook()) return false;
    bool fresh = false;
    try {
        if (const auto made = preview_.take(DenoisedPreview::Clock::now())) {
            // Its tones may be others by now.
            previewOf_.look = lookAsDrawn(session.document.look, session.where());
            renderer_.showPreview(made->image, previewOf_);
            report.previewSamples = made->of.samples;
            report.gpuBytes = renderer_.gpuBytes();
            fresh = true;
        }
        if (drawn_) beginToPreview();
    } catch (const Error& error) {
        session.say(Message::Kind::warning, "The preview cannot be denoised: " + error.message());
    }
    return fresh;
}

}  // namespace neph
