// headless.h: what tests of panels share: ImGui without a window, a session without readers.
#pragma once
#include <imgui.h>

#include <filesystem>
#include <span>

#include "app/ui/widgets/theme.h"
#include "core/plugin/plugin_host.h"

/// Frames are laid out and thrown away.
class Headless {
  public:
    Headless() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280.0f, 720.0f};
        io.DeltaTime = 0.1f;
        io.MousePos = {640.0f, 300.0f};
        neph::ui::applyTheme(1.0f);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~Headless() { ImGui::DestroyContext(); }
    Headless(const Headless&) = delete;
    Headless& operator=(const Headless&) = delete;

    void frame(auto&& content) {
        ImGui::NewFrame();
        content();
        ImGui::Render();
    }
};

inline neph::PluginHost noReaders() {
    return neph::PluginHost(std::span<const std::filesystem::path>{});
}
