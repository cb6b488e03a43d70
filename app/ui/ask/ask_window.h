// ask_window.h: what the windows of answers share.
#pragma once
#include <imgui.h>

#include <memory>
#include <string>
#include <vector>

#include "app/ui/ask/ask_state.h"
#include "app/ui/panel/panel_context.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {

/// A handle for a worker. Throws Error where the data cannot be read beside what is shown.
std::shared_ptr<Dataset> handleOf(const Dataset& data);

/// Opens a window of `ems` letters within the image, at first at `pivot` of it; pair with
/// ImGui::End().
bool beginAsk(const char* title, bool& shown, glm::vec2 ems, glm::vec2 pivot,
              const PanelContext& context);

/// What a plot may take, with a line of buttons below it.
ImVec2 plotRoom();

/// Why nothing can be asked now, or what of the data is asked.
void drawNoRun(const std::optional<AskedTime>& when);

/// Buttons that write plots, if there are any, and the numbers.
void saveButtons(const PanelContext& context, const std::string& name,
                 const std::vector<plot::Figure>& figures, const plot::Table& table);

/// The label of the time that is asked.
std::string timeOf(const AskedTime& when);

/// What goes on, or why there is no answer.
template <typename Question, typename Value>
void drawState(const PanelContext& context, Answer<Question, Value>& answer) {
    if (answer.busy()) {
        context.next.again(kLookS);
        ImGui::ProgressBar(static_cast<float>(answer.fraction()), {-1.0f, 0.0f});
    }
    if (!answer.fault().empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, errorColour());
        ImGui::TextWrapped("%s", answer.fault().c_str());
        ImGui::PopStyleColor();
    }
}

}  // namespace neph::ui
