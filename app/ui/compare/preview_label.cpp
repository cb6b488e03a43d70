// preview_label.cpp: where the words stand.
#include "app/ui/compare/preview_label.h"

#include "app/ui/widgets/image_label.h"
#include "app/ui/widgets/reference_text.h"

namespace neph::ui {
namespace {

constexpr float kSlotNameEms = 2.4f;  // width of the slot's own label, beside the line

}  // namespace

void drawPreviewLabels(const PanelContext& context, const CompareState& compare,
                       const PreviewMarks& marks) {
    const Area area = context.layout().image;
    const float em = ImGui::GetFontSize();
    const float margin = 0.6f * em, top = area.lower.y + margin;
    if (compare.mode != CompareMode::split) {
        const int samples = marks.samples.at(static_cast<std::size_t>(seenSlot(compare)));
        if (samples == 0) return;
        imageLabel(previewText(samples).c_str(), {area.lower.x + margin, top}, 0.0f, false);
        return;
    }
    // Half an image has no room for more.
    const auto label = [&](std::size_t slot, float left) {
        if (marks.samples.at(slot) > 0) imageLabel(kPreviewName, {left, top}, 0.0f, false);
    };
    label(0, area.lower.x + margin);
    label(1, area.lower.x + compare.splitAt * area.size().x + margin + kSlotNameEms * em);
}

}  // namespace neph::ui
