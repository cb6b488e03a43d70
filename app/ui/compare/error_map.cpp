// error_map.cpp: the map, its colour bar, and the words that say that this is not the image.
#include "app/ui/compare/error_map.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "app/ui/compare/error_colours.h"
#include "app/ui/widgets/image_label.h"

namespace neph::ui {
namespace {

void renewMapTexture(const Services& services, ErrorMeter& meter) {
    if (meter.drawn == meter.found) return;
    if (meter.texture != 0 && services.dropImage) services.dropImage(meter.texture);
    meter.texture = 0;
    if (meter.found && services.showImage) {
        meter.texture = services.showImage(meter.found->colours).texture;
    }
    meter.drawn = meter.found;
}

std::string mapTitle(const ErrorMeter& meter, const FrameReport& report) {
    if (meter.found && report.error) {
        return fmt::format("Error map, not the image: {} \u00d7 {} px; grey: no error beyond noise",
                           report.error->sizePx.x, report.error->sizePx.y);
    }
    if (traitsOf(report.engine).groundTruth) return "No error map: this is the reference itself";
    return meter.measures ? "Error map: measuring" : "Error map: once the image rests";
}

}  // namespace

ErrorMap errorMapOf(glm::ivec2 sizePx, std::span<const float> errors) {
    // What noise explains is no error that the scale should cover.
    std::vector<float> known(1, 0.0f);
    for (const float error : errors) {
        if (error != 0.0f) known.push_back(error);
    }
    ErrorMap map;
    map.scale = {.most = roundEnd(known), .bothSigns = true, .title = "(I-R)/R"};
    map.colours = errorColours(sizePx, errors, map.scale);
    return map;
}

void drawErrorMap(const PanelContext& context, ErrorMeter& meter, const FrameReport& report) {
    if (!meter.map) meter.found.reset();
    renewMapTexture(context.services, meter);
    if (!meter.map) return;
    const Area area = context.layout().image;
    if (meter.texture != 0) {
        drawErrorColours(area, meter.texture, meter.drawn->scale,
                         "(image \u2212 reference) / reference");
    }
    imageLabel(mapTitle(meter, report).c_str(),
               {(area.lower.x + area.upper.x) / 2.0f, area.lower.y + 0.6f * ImGui::GetFontSize()},
               0.5f, false);
}

}  // namespace neph::ui
