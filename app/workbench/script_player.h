// script_player.h: plays a script into the window, a frame at a time.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/ui/shell/ui.h"
#include "app/ui/widgets/chord.h"
#include "app/workbench/script.h"

namespace neph {

/// What mouse and keyboard do in one frame.
struct PlayedInput {
    glm::vec2 mouse{-1.0f};  ///< pixels, row 0 on top
    std::array<bool, 3> down{};
    float wheel = 0.0f;
    std::optional<ui::Chord> chord;
    std::string text;
};

/// What a script acts on.
struct ScriptWorld {
    ui::Ui& ui;
    glm::vec2 windowPx{1.0f};
    std::function<bool()> settled;  ///< nothing is read or drawn any more
    std::function<void(const std::filesystem::path&)> screenshot;
    std::function<void(glm::ivec2)> resize;
    std::function<void(const std::vector<std::filesystem::path>&)> open;
};

class ScriptPlayer {
  public:
    ScriptPlayer(std::vector<ScriptStep> steps, std::string where)
        : steps_(std::move(steps)), where_(std::move(where)) {}

    /// Input of the next frame; none when the script is over. Throws Error that names the line
    /// where something is not as the script expects.
    std::optional<PlayedInput> next(const ScriptWorld& world);

  private:
    const ScriptStep& step() const { return steps_[at_]; }
    const std::string& word(std::size_t i) const { return step().words[i]; }
    float number(std::size_t i) const;
    std::string here() const;
    bool play(const ScriptWorld& world);
    bool playMouse(const ScriptWorld& world);
    bool playClick(int presses, std::size_t button);
    bool glide(glm::vec2 from, glm::vec2 to);
    bool playMonkey(const ScriptWorld& world);
    std::optional<glm::vec2> find(const ScriptWorld& world, glm::vec2 share);
    void playAtOnce(const ScriptWorld& world);
    void playText();
    void playKey();
    void playAction(const ScriptWorld& world) const;
    void playSize(const ScriptWorld& world) const;
    void expectValue(const ScriptWorld& world) const;
    void expectFile() const;
    void expectTime(const ScriptWorld& world) const;
    void expectMember(const ScriptWorld& world) const;

    std::vector<ScriptStep> steps_;
    std::string where_;
    std::size_t at_ = 0;
    int waited_ = 0;                   // frames of this step in which its place was not there yet
    int beat_ = 0;                     // frames of this step since
    glm::vec2 from_{0.0f}, to_{0.0f};  // of a drag, pixels
    PlayedInput input_;
    std::mt19937 random_;
};

}  // namespace neph
