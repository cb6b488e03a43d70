// session_presets.cpp: applies presets to the document, and saves the document as one.
#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"
#include "core/preset/preset_files.h"
#include "core/session/session.h"

namespace neph {

void Session::setPreset(const std::string& name) {
    presetName = name;
    presetMetres_ = metres_;
    presetLook = document.look;
    presetCamera = document.camera;
    if (name.empty()) return;
    try {
        const LoadedPreset loaded = neph::loadPreset(findPreset(name));
        const Preset& preset = loaded.preset;
        presetLook = preset.look;
        presetCamera = preset.camera;
        presetMetres_ = loaded.inMetres;
        bringMetres();
        if (preset.camera) homeCamera = *preset.camera;
    } catch (const Error&) {  // deleted or unreadable: compare with the current look instead
    }
}

void Session::takeMetres(FieldSet fields) {
    metres_ = fields;
    bringMetres();
}

void Session::bringMetres() {
    if (!dataset_ || opening_) return;
    const double cellM = dataset_->finestCellM();
    bringToCells(presetLook, std::exchange(presetMetres_, 0), cellM);
    const std::string told = bringToCells(document.look, std::exchange(metres_, 0), cellM);
    if (!told.empty()) say(Message::Kind::note, told);
}

/// Commits pending changes first, so that undo returns to the look before the preset.
void Session::takePreset(const LoadedPreset& loaded, PresetParts parts, const std::string& label) {
    for (const std::string& warning : loaded.warnings) say(Message::Kind::warning, warning);
    for (const std::string& note : loaded.notes) say(Message::Kind::note, note);
    history.commit(document);
    takeOver(loaded.preset, parts, document.look, document.camera);
    if ((parts & kPresetFields) != 0) takeMetres(loaded.inMetres);
    if ((parts & kPresetCamera) != 0 && loaded.preset.camera) homeCamera = *loaded.preset.camera;
    const bool whole = parts == kPresetAll;
    const std::string step = whole ? label : fmt::format("{}: {}", label, presetPartsText(parts));
    history.commit(document, step);
    say(Message::Kind::note, step);
}

bool Session::loadPreset(const std::string& nameOrFile, PresetParts parts) {
    try {
        const LoadedPreset loaded = neph::loadPreset(findPreset(nameOrFile));
        const std::string name = presetNameOf(nameOrFile);
        takePreset(loaded, parts, "Preset " + presetLabel(name));
        if (parts != kPresetAll) return true;
        presetName = name;
        presetLook = loaded.preset.look;
        presetCamera = loaded.preset.camera;
        presetMetres_ = loaded.inMetres;
        bringMetres();
        return true;
    } catch (const Error& error) {
        say(Message::Kind::error, error.message());
        return false;
    }
}

bool Session::savePreset(const std::string& name, bool replace, std::optional<PresetText> text) {
    try {
        const PresetNameUse use = presetNameUse(name);
        if (!text && use == PresetNameUse::own) {
            const Preset before = neph::loadPreset(findPreset(name)).preset;
            text = {before.title, before.description};
        }
        const PresetText words = text.value_or(PresetText{});
        const std::filesystem::path file = saveOwnPreset(
            name, {words.title, words.description, document.look, document.camera}, replace);
        presetName = name;
        presetLook = document.look;
        presetCamera = homeCamera = document.camera;
        say(Message::Kind::note,
            fmt::format("Saved {}{}", file.string(),
                        use == PresetNameUse::bundled
                            ? "; it hides the bundled preset of that name until it is deleted"
                            : ""));
        return true;
    } catch (const Error& error) {
        say(Message::Kind::error, error.message());
        return false;
    }
}

}  // namespace neph
