// preset_thumbnails.cpp: the cards' pictures: found where they were kept, made by a program beside
// this one where they were not, and read as textures once each.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/ui/presets/preset_card.h"
#include "app/ui/presets/preset_grid.h"
#include "app/ui/shell/ui.h"
#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/session/thumbnail.h"

namespace neph::ui {
namespace {

constexpr int kNiceness = 10;  // the window has the right of way

/// Reads what is there; true when a picture is missing still.
bool readThumbnails(Ui& ui) {
    bool missing = false;
    for (PresetCard& card : ui.presets.cards) {
        if (card.texture != 0 || card.thumbnail.empty() || !card.fault.empty()) continue;
        std::error_code fault;
        if (std::filesystem::exists(card.thumbnail, fault)) {
            card.texture = ui.services.loadPicture(card.thumbnail).texture;
            if (card.texture == 0) card.thumbnail.clear();  // no picture: not again
        } else {
            missing = true;
        }
    }
    return missing;
}

void startMaker(Ui& ui) {
    ui.presets.triedThumbnails = true;
    try {
        ui.presets.thumbnails = std::make_unique<ChildProcess>(
            programDir() / "nephoscope", std::vector<std::string>{"thumbnails"},
            ChildProcess::Options{kNiceness, false});
    } catch (const Error& error) {
        ui.session().say(Message::Kind::warning, error.message());
    }
}

}  // namespace

void updateThumbnails(Ui& ui) {
    PresetBrowser& presets = ui.presets;
    if (!ui.services.loadPicture) return;
    const bool missing = readThumbnails(ui);
    if (!presets.thumbnails) {
        if (missing && !presets.triedThumbnails) startMaker(ui);
        return;
    }
    ui.again(kLookS);
    if (presets.thumbnails->poll()) return;
    if (presets.thumbnails->status() != 0) {
        ui.session().say(Message::Kind::warning, "The presets' pictures could not be made: " +
                                                     presets.thumbnails->lastWords());
    }
    presets.thumbnails.reset();
}

void keepThumbnails(Ui& ui, std::vector<PresetCard>& cards) {
    for (PresetCard& card : cards) {
        if (ui.services.loadPicture && card.fault.empty()) {
            card.thumbnail = thumbnailFile(card.entry).value_or(std::filesystem::path());
        }
        const auto before =
            std::ranges::find(ui.presets.cards, card.thumbnail, &PresetCard::thumbnail);
        if (before == ui.presets.cards.end() || card.thumbnail.empty()) continue;
        card.texture = std::exchange(before->texture, 0u);
    }
    for (const PresetCard& card : ui.presets.cards) {
        if (card.texture != 0 && ui.services.dropPicture) ui.services.dropPicture(card.texture);
    }
}

}  // namespace neph::ui
