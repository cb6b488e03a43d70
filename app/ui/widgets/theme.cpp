// theme.cpp: colours tuned by eye; Roboto from Debian's fonts-roboto-unhinted, and what it lacks
// from fonts-dejavu-core.
//
// Text and what it stands on differ by 4.5 : 1 or more (WCAG 2.1, 1.4.3); a test holds that.
#include "app/ui/widgets/theme.h"

#include <imgui_internal.h>  // letters of UTF-8

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "core/base/resources.h"

namespace neph::ui {
namespace {

constexpr float kLeastTextScale = 0.75f, kMostTextScale = 3.0f;

struct FontFile {
    const char* path;
    float sizePx;  // of a line: letters of about 10 pixels, whatever the face
};
constexpr std::array kFonts{
    FontFile{"/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf", 16.0f},
    FontFile{"/usr/share/fonts/TTF/Roboto-Regular.ttf", 16.0f},
    FontFile{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 15.0f},
    FontFile{"/usr/share/fonts/TTF/DejaVuSans.ttf", 15.0f}};
constexpr float kOwnFontPx = 13.0f;        // ImGui's, drawn for this size
constexpr ImWchar kFirstEastern = 0x2e80;  // of the Unicode block of CJK radicals

/// Latin, Greek, punctuation, super- and subscripts, arrows, signs of mathematics, shapes.
constexpr std::array<ImWchar, 15> kGlyphs{0x0020, 0x00ff, 0x0370, 0x03ff, 0x2010,
                                          0x205e, 0x2070, 0x209c, 0x2190, 0x21ff,
                                          0x2200, 0x2265, 0x25a0, 0x25ff, 0};

/// Debian's fonts-noto-cjk, fonts-droid-fallback, fonts-wqy-*, fonts-ipafont-gothic and
/// fonts-nanum; Fedora's and Arch's Noto.
constexpr std::array kWholeEast{
    "opentype/noto/NotoSansCJK-Regular.ttc",
    "noto-cjk/NotoSansCJK-Regular.ttc",
    "google-noto-cjk/NotoSansCJK-Regular.ttc",
    "google-noto-sans-cjk-fonts/NotoSansCJK-Regular.ttc",
    "NotoSansCJK-Regular.ttc",
};
constexpr std::array kPartsOfEast{
    "truetype/droid/DroidSansFallbackFull.ttf",
    "droid/DroidSansFallbackFull.ttf",
    "DroidSansFallbackFull.ttf",
    "truetype/wqy/wqy-microhei.ttc",
    "truetype/wqy/wqy-zenhei.ttc",
    "wenquanyi/wqy-microhei/wqy-microhei.ttc",
    "opentype/ipafont-gothic/ipag.ttf",
    "truetype/nanum/NanumGothic.ttf",
};

/// Letters beyond kGlyphs that texts have. There is one font.
struct AskedGlyphs {
    std::set<ImWchar> letters;
    std::vector<ImWchar> ranges;  // of them, as ImGui wants them while it makes the font
    bool more = false;            // since the font was loaded
};
AskedGlyphs asked;

struct Tint {
    ImGuiCol_ which;
    float dark, light;  // levels of grey
};
constexpr std::array kTints{
    Tint{ImGuiCol_Text, 0.90f, 0.10f},
    Tint{ImGuiCol_TextDisabled, 0.62f, 0.36f},
    Tint{ImGuiCol_WindowBg, 0.105f, 0.93f},
    Tint{ImGuiCol_PopupBg, 0.135f, 0.975f},
    Tint{ImGuiCol_MenuBarBg, 0.135f, 0.88f},
    Tint{ImGuiCol_Border, 0.28f, 0.70f},
    Tint{ImGuiCol_FrameBg, 0.19f, 0.83f},
    Tint{ImGuiCol_FrameBgHovered, 0.24f, 0.79f},
    Tint{ImGuiCol_FrameBgActive, 0.26f, 0.76f},
    Tint{ImGuiCol_Header, 0.165f, 0.865f},
    Tint{ImGuiCol_HeaderHovered, 0.23f, 0.80f},
    Tint{ImGuiCol_HeaderActive, 0.26f, 0.77f},
    Tint{ImGuiCol_Button, 0.21f, 0.81f},
    Tint{ImGuiCol_ButtonHovered, 0.28f, 0.75f},
    Tint{ImGuiCol_Separator, 0.24f, 0.76f},
    Tint{ImGuiCol_TitleBg, 0.13f, 0.88f},
    Tint{ImGuiCol_TitleBgActive, 0.165f, 0.865f},
    Tint{ImGuiCol_ScrollbarBg, 0.09f, 0.90f},
    Tint{ImGuiCol_ScrollbarGrab, 0.28f, 0.70f},
    Tint{ImGuiCol_ScrollbarGrabHovered, 0.36f, 0.60f},
    Tint{ImGuiCol_ScrollbarGrabActive, 0.42f, 0.52f},
    Tint{ImGuiCol_TableHeaderBg, 0.165f, 0.865f},
    Tint{ImGuiCol_TableBorderStrong, 0.28f, 0.70f},
    Tint{ImGuiCol_TableBorderLight, 0.21f, 0.80f},
    Tint{ImGuiCol_PlotLines, 0.62f, 0.36f},
};

/// One colour that is not grey: for marks and lines, and dimmer for what text stands on.
struct Accent {
    ImVec4 mark, ground, held;
};
const Accent kDark{
    {0.40f, 0.63f, 0.88f, 1.0f}, {0.20f, 0.35f, 0.51f, 1.0f}, {0.24f, 0.40f, 0.58f, 1.0f}};
const Accent kLight{
    {0.10f, 0.36f, 0.64f, 1.0f}, {0.66f, 0.79f, 0.93f, 1.0f}, {0.58f, 0.74f, 0.91f, 1.0f}};

/// A grey with a little blue in it.
ImVec4 grey(float level) {
    return {level - 0.005f, level, level + 0.01f, 1.0f};
}

void colour(Theme theme) {
    const bool dark = theme == Theme::dark;
    dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
    auto& colours = ImGui::GetStyle().Colors;
    for (const Tint& tint : kTints) colours[tint.which] = grey(dark ? tint.dark : tint.light);
    const Accent& accent = dark ? kDark : kLight;
    for (const ImGuiCol_ which :
         {ImGuiCol_CheckMark, ImGuiCol_PlotHistogram, ImGuiCol_SeparatorHovered,
          ImGuiCol_SeparatorActive, ImGuiCol_DragDropTarget, ImGuiCol_NavHighlight}) {
        colours[which] = accent.mark;
    }
    for (const ImGuiCol_ which :
         {ImGuiCol_ButtonActive, ImGuiCol_SliderGrab, ImGuiCol_TextSelectedBg}) {
        colours[which] = accent.ground;
    }
    colours[ImGuiCol_SliderGrabActive] = accent.held;
    colours[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.35f};
}

void space(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = style.ChildRounding = style.ScrollbarRounding = 0.0f;
    style.FrameRounding = style.GrabRounding = style.TabRounding = 3.0f;
    style.PopupRounding = 4.0f;
    style.WindowBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.WindowPadding = {10.0f, 8.0f};
    style.FramePadding = {6.0f, 3.0f};
    style.ItemSpacing = {6.0f, 4.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 11.0f;
    style.ScaleAllSizes(scale);
    style.WindowMinSize = {1.0f,
                           1.0f};  // less than a pixel, which ImGui refuses, if it were scaled
}

bool isLight() {
    return ImGui::GetStyle().Colors[ImGuiCol_WindowBg].y > 0.5f;
}

bool addFont(const std::filesystem::path& file, float sizePx, bool merged,
             const ImWchar* glyphs = kGlyphs.data()) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return false;
    ImFontConfig config;
    config.MergeMode = merged;
    config.OversampleH = 2;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), sizePx, &config, glyphs) !=
           nullptr;
}

bool isOwnGlyph(ImWchar letter) {
    for (std::size_t i = 0; i + 1 < kGlyphs.size(); i += 2) {
        if (letter >= kGlyphs[i] && letter <= kGlyphs[i + 1]) return true;
    }
    return false;
}

void makeRanges() {
    asked.ranges.clear();
    for (const ImWchar letter : asked.letters) {
        if (!asked.ranges.empty() && asked.ranges.back() + 1 == letter) {
            asked.ranges.back() = letter;
        } else {
            asked.ranges.insert(asked.ranges.end(), {letter, letter});
        }
    }
    asked.ranges.push_back(0);
    asked.more = false;
}

/// Of the system and of the user.
std::vector<std::filesystem::path> fontFolders() {
    std::vector<std::filesystem::path> folders;
    if (const auto data = userDataDir()) folders.push_back(data->parent_path() / "fonts");
    folders.insert(folders.end(), {"/usr/share/fonts", "/usr/local/share/fonts"});
    return folders;
}

/// To the fonts that are there already: from those first, then from one of the East.
void addAskedGlyphs(float sizePx, bool merged) {
    makeRanges();
    if (asked.letters.empty()) return;
    for (const FontFile& font : kFonts) {
        merged |= addFont(font.path, sizePx, merged, asked.ranges.data());
    }
    const bool eastern = *asked.letters.rbegin() >= kFirstEastern;
    if (!eastern) return;
    for (const std::filesystem::path& file : eastAsianFonts(fontFolders())) {
        merged |= addFont(file, sizePx, merged, asked.ranges.data());
    }
}

}  // namespace

void applyTheme(float scale, Theme theme) {
    ImGui::GetStyle() = ImGuiStyle();  // sizes are scaled from what they are: begin again
    colour(theme);
    space(scale);
}

void loadFont(float scale) {
    bool found = false;
    float sizePx = 0.0f;
    // The first has its say; those after it give the glyphs that it lacks.
    for (const FontFile& font : kFonts) {
        if (!found) sizePx = font.sizePx * scale;
        found |= addFont(font.path, sizePx, found);
    }
    if (found) return addAskedGlyphs(sizePx, true);
    ImFontConfig config;
    config.SizePixels = kOwnFontPx * scale;
    ImGui::GetIO().Fonts->AddFontDefault(&config);
}

std::vector<std::filesystem::path> eastAsianFonts(std::span<const std::filesystem::path> folders) {
    std::vector<std::filesystem::path> found;
    const auto look = [&](std::span<const char* const> names) {
        std::error_code error;
        for (const char* name : names) {
            for (const auto& folder : folders) {
                if (std::filesystem::is_regular_file(folder / name, error)) {
                    found.push_back(folder / name);
                }
            }
        }
    };
    look(kWholeEast);
    if (!found.empty()) return {found.front()};
    look(kPartsOfEast);
    return found;
}

void wantGlyphs(std::string_view text) {
    for (const char* at = text.data(); at < text.data() + text.size();) {
        if (static_cast<unsigned char>(*at) < 0x80U) {
            ++at;
            continue;
        }
        unsigned letter = 0;
        at += std::max(1, ImTextCharFromUtf8(&letter, at, text.data() + text.size()));
        if (letter > IM_UNICODE_CODEPOINT_MAX || letter == IM_UNICODE_CODEPOINT_INVALID) continue;
        const auto glyph = static_cast<ImWchar>(letter);
        if (!isOwnGlyph(glyph)) asked.more |= asked.letters.insert(glyph).second;
    }
}

bool lacksGlyphs() {
    return asked.more;
}

void restyle(float scale, const Settings& settings) {
    const float whole = scale * std::clamp(settings.textScale, kLeastTextScale, kMostTextScale);
    applyTheme(whole, settings.theme);
    ImGui::GetIO().Fonts->Clear();
    loadFont(whole);
}

ImVec4 warningColour() {
    return isLight() ? ImVec4{0.52f, 0.34f, 0.0f, 1.0f} : ImVec4{0.95f, 0.80f, 0.45f, 1.0f};
}

ImVec4 errorColour() {
    return isLight() ? ImVec4{0.70f, 0.12f, 0.08f, 1.0f} : ImVec4{0.98f, 0.58f, 0.50f, 1.0f};
}

}  // namespace neph::ui
