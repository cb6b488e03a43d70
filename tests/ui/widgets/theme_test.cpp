// theme_test.cpp: what is written can be read, in both themes.
#include "app/ui/widgets/theme.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "tests/temporary_folder.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// WCAG 2.1: relative luminance, and the ratio of two.
double luminance(const ImVec4& colour) {
    const auto linear = [](float value) {
        const auto v = static_cast<double>(value);
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.x) + 0.7152 * linear(colour.y) + 0.0722 * linear(colour.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

constexpr std::array kGrounds{
    ImGuiCol_WindowBg,      ImGuiCol_PopupBg,          ImGuiCol_MenuBarBg,
    ImGuiCol_FrameBg,       ImGuiCol_FrameBgHovered,   ImGuiCol_FrameBgActive,
    ImGuiCol_Button,        ImGuiCol_ButtonHovered,    ImGuiCol_ButtonActive,
    ImGuiCol_Header,        ImGuiCol_HeaderHovered,    ImGuiCol_HeaderActive,
    ImGuiCol_SliderGrab,    ImGuiCol_SliderGrabActive, ImGuiCol_TitleBg,
    ImGuiCol_TitleBgActive, ImGuiCol_TextSelectedBg,   ImGuiCol_TableHeaderBg};
constexpr std::array kPanels{ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg};

}  // namespace

TEST_CASE("The contrast of black on white is 21, and of a colour with itself 1") {
    CHECK(contrast({0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f, 1.0f}) == doctest::Approx(21.0));
    CHECK(contrast({0.5f, 0.5f, 0.5f, 1.0f}, {0.5f, 0.5f, 0.5f, 1.0f}) == 1.0);
}

TEST_CASE("Text differs from all that it stands on by 4.5 to 1, in the dark and the light theme") {
    Headless gui;
    for (const Theme theme : {Theme::dark, Theme::light}) {
        CAPTURE(static_cast<int>(theme));
        ui::applyTheme(1.0f, theme);
        const auto& colours = ImGui::GetStyle().Colors;
        for (const ImGuiCol_ ground : kGrounds) {
            CAPTURE(ImGui::GetStyleColorName(ground));
            CHECK(colours[ground].w == 1.0f);
            CHECK(contrast(colours[ImGuiCol_Text], colours[ground]) >= 4.5);
        }
        for (const ImGuiCol_ ground : kPanels) {
            CAPTURE(ImGui::GetStyleColorName(ground));
            CHECK(contrast(colours[ImGuiCol_TextDisabled], colours[ground]) >= 4.5);
            CHECK(contrast(ui::warningColour(), colours[ground]) >= 4.5);
            CHECK(contrast(ui::errorColour(), colours[ground]) >= 4.5);
            CHECK(contrast(colours[ImGuiCol_CheckMark], colours[ground]) >= 3.0);  // of marks
        }
    }
}

TEST_CASE("Sizes follow the scale, however often the style is made again") {
    Headless gui;
    ui::applyTheme(1.0f);
    const float one = ImGui::GetStyle().ItemSpacing.x;
    for (int i = 0; i < 3; ++i) ui::applyTheme(2.0f, Theme::light);
    CHECK(ImGui::GetStyle().ItemSpacing.x == 2.0f * one);
    ui::applyTheme(1.0f);
    CHECK(ImGui::GetStyle().ItemSpacing.x == one);
    CHECK(ImGui::GetStyle().GrabMinSize == 10.0f);  // as ImGui has it
}

TEST_CASE("ImGui takes the sizes of the smallest and of the largest text") {
    Headless gui;
    for (const float scale : {0.5f, 0.75f, 3.0f, 6.0f}) {
        ui::applyTheme(scale, Theme::dark);
        CHECK(ImGui::GetStyle().WindowMinSize.x >= 1.0f);  // ImGui's own check of a frame
        gui.frame([] {});
    }
}

TEST_CASE("The font follows the scale of the text and has the signs that panels write") {
    Headless gui;
    Settings settings;
    settings.textScale = 1.5f;
    ui::restyle(2.0f, settings);
    const ImFont* font = ImGui::GetIO().Fonts->Fonts.front();
    ImGui::GetIO().Fonts->Build();
    CHECK(font->FontSize >= 3.0f * 13.0f);
    if (ImGui::GetIO().Fonts->ConfigData.front().Name[0] == 'P') return;  // ProggyClean: none is
    for (const char16_t sign :
         std::u16string_view(u"\u00b0\u00b5\u03b8\u00b3\u207b\u2192\u00d7\u2264")) {
        CAPTURE(static_cast<int>(sign));
        CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(sign)) != nullptr);
    }
}

TEST_CASE("Letters that names have are loaded when they are asked for, and no others") {
    Headless gui;
    const Settings settings;
    const auto has = [](ImWchar letter) {
        ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
        fonts.Build();
        return fonts.Fonts[0]->FindGlyphNoFallback(letter) != nullptr;
    };
    ui::restyle(1.0f, settings);
    constexpr ImWchar kAlpha = 0x03b1, kZhe = 0x0416, kSha = 0x0428;
    if (!has(kAlpha)) {
        MESSAGE("no font is installed: there is nothing to test");
        return;
    }
    CHECK_FALSE(has(kZhe));
    CHECK_FALSE(ui::lacksGlyphs());
    ui::wantGlyphs("wrfout_d01 \u03b1 \u00b5m");  // of those that are always there
    CHECK_FALSE(ui::lacksGlyphs());
    ui::wantGlyphs("\u0416_d01.nc\xff");
    CHECK(ui::lacksGlyphs());
    ui::restyle(1.0f, settings);
    CHECK_FALSE(ui::lacksGlyphs());
    CHECK(has(kZhe));
    CHECK_FALSE(has(kSha));
    ui::wantGlyphs("\u0416\u0416");
    CHECK_FALSE(ui::lacksGlyphs());
}

TEST_CASE("Fonts for the East are looked for where systems and users put them") {
    const TemporaryFolder system, user;
    const std::array folders{user.path(), system.path()};
    using Files = std::vector<std::filesystem::path>;
    CHECK(ui::eastAsianFonts(folders).empty());
    const auto put = [](const std::filesystem::path& file) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << "font";
        return file;
    };
    const auto hangul = put(system / "truetype/nanum/NanumGothic.ttf");
    CHECK(ui::eastAsianFonts(folders) == Files{hangul});
    const auto han = put(user / "DroidSansFallbackFull.ttf");
    CHECK(ui::eastAsianFonts(folders) == Files{han, hangul});
    const auto all = put(system / "opentype/noto/NotoSansCJK-Regular.ttc");
    CHECK(ui::eastAsianFonts(folders) == Files{all});
}

TEST_CASE("Names in Chinese, Japanese and Korean are shown where the system has a font for them") {
    const std::array<std::filesystem::path, 1> system{"/usr/share/fonts"};
    if (ui::eastAsianFonts(system).empty()) {
        MESSAGE("no such font is installed: there is nothing to test");
        return;
    }
    Headless gui;
    ui::wantGlyphs("\u53f0\u98ce");
    ui::restyle(1.0f, {});
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Build();
    for (const ImWchar letter : {ImWchar{0x53f0}, ImWchar{0x98ce}}) {
        CHECK(fonts.Fonts[0]->FindGlyphNoFallback(letter) != nullptr);
    }
}
