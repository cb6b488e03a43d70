// ask_window.cpp: frames of answers, and saving them.
#include "app/ui/ask/ask_window.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/ui/widgets/places.h"
#include "core/base/error.h"

namespace neph::ui {

std::shared_ptr<Dataset> handleOf(const Dataset& data) {
    std::shared_ptr<Dataset> handle = data.anotherHandle();
    if (handle) return handle;
    throw Error({.where = data.info().reader,
                 .what = "the reader gives only one handle",
                 .hint = "ask by the command line: nephoscope probe, section or series"});
}

bool beginAsk(const char* title, bool& shown, glm::vec2 ems, glm::vec2 pivot,
              const PanelContext& context) {
    const float em = ImGui::GetFontSize();
    const Area image = context.layout().image;
    const glm::vec2 room = image.size() - em;
    const glm::vec2 size = glm::min(ems * em, room);
    const glm::vec2 at = glm::mix(image.lower + 0.5f * em, image.upper - 0.5f * em, pivot);
    ImGui::SetNextWindowPos({at.x, at.y}, ImGuiCond_Appearing, {pivot.x, pivot.y});
    ImGui::SetNextWindowSize({size.x, size.y}, ImGuiCond_Appearing);
    return ImGui::Begin(title, &shown,
                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
}

ImVec2 plotRoom() {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    return {room.x, std::max(room.y - ImGui::GetFrameHeightWithSpacing(), 80.0f)};
}

void drawNoRun(const std::optional<AskedTime>& when) {
    if (when && !when->data->nests().empty()) {
        ImGui::TextDisabled("The image has nests; this is of the outermost domain.");
    }
    if (when) return;
    ImGui::TextWrapped(
        "Columns, sections and series are of one run: choose a member that has this time.");
}

void saveButtons(const PanelContext& context, const std::string& name,
                 const std::vector<plot::Figure>& figures, const plot::Table& table) {
    if (!context.services.savePlots) return;
    for (const char* kind : {"svg", "png", "csv"}) {
        if (figures.empty() && std::string_view(kind) != "csv") continue;
        const bool pressed = ImGui::SmallButton(kind);
        place(fmt::format("ask.save.{}", kind));
        ImGui::SameLine();
        if (!pressed) continue;
        try {
            const std::string file =
                context.services.savePlots(fmt::format("{}.{}", name, kind), figures, table);
            context.session().say(Message::Kind::note, "Wrote " + file);
        } catch (const Error& error) {
            context.session().say(Message::Kind::error, error.message());
        }
    }
    ImGui::TextDisabled("saves it");
}

std::string timeOf(const AskedTime& when) {
    return when.data->info().times.at(static_cast<std::size_t>(when.time)).label;
}

}  // namespace neph::ui
