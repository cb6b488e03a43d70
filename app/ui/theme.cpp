// theme.cpp: colours tuned by eye; DejaVu Sans from Debian's fonts-dejavu-core.
#include "app/ui/theme.h"

#include <imgui.h>

#include <array>
#include <filesystem>

namespace neph::ui {
namespace {

constexpr float kFontPx = 14.0f;
constexpr std::array kFonts{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                            "/usr/share/fonts/TTF/DejaVuSans.ttf"};

struct Tint {
    ImGuiCol_ which;
    ImVec4 colour;
};

ImVec4 grey(float level, float alpha = 1.0f) {
    return {level * 0.94f, level, level * 1.08f, alpha};
}
const ImVec4 kAccent{0.33f, 0.55f, 0.78f, 1.0f};
const ImVec4 kAccentDim{0.22f, 0.37f, 0.53f, 1.0f};

const std::array kTints{
    Tint{ImGuiCol_Text, grey(0.86f)},
    Tint{ImGuiCol_TextDisabled, grey(0.50f)},
    Tint{ImGuiCol_WindowBg, grey(0.10f, 0.90f)},
    Tint{ImGuiCol_PopupBg, grey(0.12f, 0.97f)},
    Tint{ImGuiCol_Border, grey(0.24f, 0.60f)},
    Tint{ImGuiCol_FrameBg, grey(0.19f)},
    Tint{ImGuiCol_FrameBgHovered, grey(0.25f)},
    Tint{ImGuiCol_FrameBgActive, grey(0.28f)},
    Tint{ImGuiCol_Header, grey(0.17f)},
    Tint{ImGuiCol_HeaderHovered, grey(0.24f)},
    Tint{ImGuiCol_HeaderActive, grey(0.27f)},
    Tint{ImGuiCol_Button, grey(0.21f)},
    Tint{ImGuiCol_ButtonHovered, grey(0.29f)},
    Tint{ImGuiCol_ButtonActive, kAccentDim},
    Tint{ImGuiCol_SliderGrab, kAccentDim},
    Tint{ImGuiCol_SliderGrabActive, kAccent},
    Tint{ImGuiCol_CheckMark, kAccent},
    Tint{ImGuiCol_PlotHistogram, kAccent},
    Tint{ImGuiCol_Separator, grey(0.22f)},
    Tint{ImGuiCol_TitleBg, grey(0.12f)},
    Tint{ImGuiCol_TitleBgActive, grey(0.15f)},
    Tint{ImGuiCol_ScrollbarBg, grey(0.08f, 0.40f)},
    Tint{ImGuiCol_ModalWindowDimBg, {0.0f, 0.0f, 0.0f, 0.35f}},
    Tint{ImGuiCol_TextSelectedBg, kAccentDim},
};

}  // namespace

void applyTheme(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    for (const Tint& tint : kTints) style.Colors[tint.which] = tint.colour;
    style.WindowRounding = 0.0f;
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.PopupRounding = 4.0f;
    style.WindowBorderSize = 0.0f;
    style.WindowPadding = {10.0f, 8.0f};
    style.FramePadding = {6.0f, 2.0f};
    style.ItemSpacing = {6.0f, 4.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 10.0f;
    style.ScaleAllSizes(scale);
}

void loadFont(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* file : kFonts) {
        std::error_code error;
        if (!std::filesystem::exists(file, error)) continue;
        if (io.Fonts->AddFontFromFileTTF(file, kFontPx * scale) != nullptr) return;
    }
    ImFontConfig config;
    config.SizePixels = kFontPx * scale;
    io.Fonts->AddFontDefault(&config);
}

}  // namespace neph::ui
