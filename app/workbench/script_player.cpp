// script_player.cpp: commands into what mouse and keyboard do, frame by frame.
#include "app/workbench/script_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "app/ui/shell/actions.h"
#include "app/ui/widgets/places.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/look/parameter.h"

namespace neph {
namespace {

constexpr int kPatience = 200;    // frames to wait for a place that panels have yet to draw
constexpr int kGlideFrames = 6;   // of a drag between its ends
constexpr int kMonkeyBatch = 8;   // random events in a frame
constexpr int kEarliestWait = 4;  // frames until work that was asked for is under way

std::optional<glm::vec2> pairOf(const std::string& text, char between) {
    glm::vec2 pair{0.0f};
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pair.x);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != between) return {};
    const auto second = std::from_chars(first.ptr + 1, end, pair.y);
    if (second.ec != std::errc{} || second.ptr != end) return {};
    return pair;
}

glm::vec2 imageCentre(const ScriptWorld& world) {
    const PixelBox box = ui::imageBox(world.ui.layout());
    const glm::vec2 centre = glm::vec2(box.lower + box.upper) / 2.0f;
    return {centre.x, world.windowPx.y - centre.y};
}

}  // namespace

std::string ScriptPlayer::here() const {
    return fmt::format("{}, line {}", where_, step().line);
}

float ScriptPlayer::number(std::size_t i) const {
    float value = 0.0f;
    const std::string& text = word(i);
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault == std::errc{} && end == text.data() + text.size()) return value;
    throw Error({here(), "cannot be read as a number", text, "a number", ""});
}

/// Where the step's place is; none while panels have yet to draw it. Throws when they do not.
std::optional<glm::vec2> ScriptPlayer::find(const ScriptWorld& world, glm::vec2 share) {
    const std::string& name = word(0);
    if (name == "image") return imageCentre(world);
    if (const auto pair = pairOf(name, ',')) return *pair * world.windowPx;
    if (const auto place = ui::placeOf(name)) {
        return place->lower + share * (place->upper - place->lower);
    }
    if (++waited_ < kPatience) return {};
    const std::vector<std::string> known = ui::knownPlaces();
    const std::vector<std::string_view> names(known.begin(), known.end());
    const std::string_view near = nearestName(name, names);
    throw Error({here(), fmt::format("there is nothing called {} on the screen", name), "",
                 fmt::format("one of {} places", known.size()),
                 near.empty() ? "" : fmt::format("did you mean {}?", near)});
}

/// The mouse is there, goes down, comes up, as often as asked, and is seen to be up.
bool ScriptPlayer::playClick(int presses, std::size_t button) {
    input_.down[button] = beat_ % 2 == 1 && beat_ < 2 * presses;
    return beat_++ > 2 * presses;
}

/// A drag with the left button.
bool ScriptPlayer::glide(glm::vec2 from, glm::vec2 to) {
    const float share = std::clamp(static_cast<float>(beat_ - 2) / kGlideFrames, 0.0f, 1.0f);
    input_.mouse = glm::mix(from, to, share);
    input_.down[0] = beat_ >= 1 && beat_ < kGlideFrames + 3;
    return beat_++ > kGlideFrames + 3;
}

bool ScriptPlayer::playMouse(const ScriptWorld& world) {
    const ScriptCommand command = step().command;
    if (command == ScriptCommand::orbit) {
        if (beat_ == 0) from_ = imageCentre(world);
        return glide(from_, from_ + glm::vec2(number(0), number(1)) * world.windowPx);
    }
    const bool pulls = command == ScriptCommand::pull;
    if (command == ScriptCommand::drag || pulls) {
        if (beat_ > 0) return glide(from_, to_);
        const auto from = find(world, {pulls ? 0.5f : number(1), 0.5f});
        if (!from) return false;
        from_ = *from;
        to_ = pulls ? from_ + glm::vec2(number(1), number(2)) * world.windowPx
                    : find(world, {number(2), 0.5f}).value_or(from_);
        return glide(from_, to_);
    }
    const std::optional<glm::vec2> at = beat_ > 0 ? input_.mouse : find(world, {0.5f, 0.5f});
    if (!at) return false;
    input_.mouse = *at;
    const bool wheel = command == ScriptCommand::wheel;
    if (wheel) input_.wheel = beat_ == 1 ? number(1) : 0.0f;
    if (wheel || command == ScriptCommand::move) return beat_++ > 1;
    return playClick(command == ScriptCommand::doubleClick ? 2 : 1,
                     command == ScriptCommand::rightClick ? 1 : 0);
}

/// Any mouse, wheel, key and text, but for what ends the program.
bool ScriptPlayer::playMonkey(const ScriptWorld& world) {
    if (beat_ == 0) random_.seed(static_cast<unsigned>(number(1)));
    const auto draw = [this](int count) {
        return static_cast<int>(random_() % static_cast<unsigned>(count));
    };
    for (int i = 0; i < kMonkeyBatch; ++i, ++beat_) {
        switch (draw(8)) {
            case 0:
            case 1:
                input_.mouse = world.windowPx * glm::vec2(static_cast<float>(draw(1000)) / 1e3f,
                                                          static_cast<float>(draw(1000)) / 1e3f);
                break;
            case 2:
                input_.mouse += glm::vec2(draw(41) - 20, draw(41) - 20);
                break;
            case 3:
                input_.down[static_cast<std::size_t>(draw(3))] = draw(2) == 0;
                break;
            case 4:
                input_.wheel = static_cast<float>(draw(7) - 3);
                break;
            case 5:
                input_.text += static_cast<char>(' ' + draw(95));
                break;
            default:
                input_.chord = ui::Chord{static_cast<ui::Key>(draw(ui::kKeyCount)), draw(3) == 0,
                                         draw(3) == 0};
        }
    }
    if (input_.chord == ui::Chord{ui::Key::q, true}) input_.chord.reset();
    const bool over = beat_ >= static_cast<int>(number(0));
    if (over) input_.down = {};
    return over;
}

void ScriptPlayer::expectFile() const {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(word(0), error);
    if (!error && bytes > 0) return;
    throw Error({here(), word(0) + " is not there or is empty", error.message(), "", ""});
}

void ScriptPlayer::expectTime(const ScriptWorld& world) const {
    const int time = world.ui.session().document.time;
    if (time == static_cast<int>(number(0))) return;
    throw Error({here(), "another time is shown", std::to_string(time), word(0), ""});
}

void ScriptPlayer::expectMember(const ScriptWorld& world) const {
    const Session& session = world.ui.session();
    const Ensemble* ensemble = session.ensemble();
    const std::string found = ensemble ? ensemble->nameOf(session.document.member) : "no ensemble";
    if (found != word(0)) throw Error({here(), "another member is shown", found, word(0), ""});
}

void ScriptPlayer::expectValue(const ScriptWorld& world) const {
    const std::size_t equals = word(0).find('=');
    const Parameter& row = parameter(word(0).substr(0, equals));
    const std::string wanted = equals == std::string::npos ? "" : word(0).substr(equals + 1);
    const std::string found = formatValue(row, valueOf(world.ui.session().document, row));
    const std::string expected = formatValue(row, parseValue(row, wanted, here()));
    if (found != expected) throw Error({here(), row.id + " is another", found, expected, ""});
}

void ScriptPlayer::playText() {
    for (const std::string& part : step().words) {
        input_.text += (input_.text.empty() ? "" : " ") + part;
    }
}

void ScriptPlayer::playKey() {
    input_.chord = ui::parseChord(word(0));
    if (!input_.chord) throw Error({here(), "there is no such key", word(0), "Ctrl+Z", ""});
}

void ScriptPlayer::playAction(const ScriptWorld& world) const {
    if (ui::runAction(world.ui, word(0))) return;
    throw Error({here(), "there is no such action, or it is not enabled", word(0), "", ""});
}

void ScriptPlayer::playSize(const ScriptWorld& world) const {
    const auto size = pairOf(word(0), 'x');
    if (!size) throw Error({here(), "cannot be read as a size", word(0), "1280x720", ""});
    world.resize(glm::ivec2(*size));
}

/// Plays a frame of the step; true when it is over.
bool ScriptPlayer::play(const ScriptWorld& world) {
    switch (step().command) {
        case ScriptCommand::wait:
            return beat_++ > kEarliestWait && world.settled();
        case ScriptCommand::frames:
            return ++beat_ >= static_cast<int>(number(0));
        case ScriptCommand::monkey:
            return playMonkey(world);
        case ScriptCommand::expectPlace:
            return find(world, {0.5f, 0.5f}).has_value();
        case ScriptCommand::move:
        case ScriptCommand::click:
        case ScriptCommand::rightClick:
        case ScriptCommand::doubleClick:
        case ScriptCommand::drag:
        case ScriptCommand::pull:
        case ScriptCommand::orbit:
        case ScriptCommand::wheel:
            return playMouse(world);
        default:
            playAtOnce(world);
            return true;
    }
}

/// Steps that are over within one frame.
void ScriptPlayer::playAtOnce(const ScriptWorld& world) {
    switch (step().command) {
        case ScriptCommand::expect:
            return expectValue(world);
        case ScriptCommand::expectFile:
            return expectFile();
        case ScriptCommand::expectTime:
            return expectTime(world);
        case ScriptCommand::expectMember:
            return expectMember(world);
        case ScriptCommand::screenshot:
            return world.screenshot(word(0));
        case ScriptCommand::set:
            return applyAssignment(world.ui.session().document, word(0));
        case ScriptCommand::open:
            return world.open({step().words.begin(), step().words.end()});
        case ScriptCommand::text:
            return playText();
        case ScriptCommand::key:
            return playKey();
        case ScriptCommand::action:
            return playAction(world);
        case ScriptCommand::size:
            return playSize(world);
        default:
            return;
    }
}

std::optional<PlayedInput> ScriptPlayer::next(const ScriptWorld& world) {
    if (at_ >= steps_.size()) return {};
    input_.wheel = 0.0f;
    input_.chord.reset();
    input_.text.clear();
    if (play(world)) {
        ++at_;
        waited_ = beat_ = 0;
    }
    return input_;
}

}  // namespace neph
