// preset_thumbnails.cpp: the cards' images: found where they were kept, made by a program beside
// this one where they were not, and read as textures once each.
#include "app/ui/presets/preset_thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/session/thumbnail.h"

namespace neph::ui {
namespace {

constexpr int kNiceness = 10;  // the window has the right of way

/// Reads what is there; true when an image is missing still.
bool readThumbnails(const Services& services, PresetBrowser& presets) {
    bool missing = false;
    for (PresetCard& card : presets.cards) {
        if (card.texture != 0 || card.thumbnail.empty() || !card.fault.empty()) continue;
        std::error_code fault;
        if (std::filesystem::exists(card.thumbnail, fault)) {
            card.texture = services.loadImage(card.thumbnail).texture;
            if (card.texture == 0) card.thumbnail.clear();  // no image: not again
        } else {
            missing = true;
        }
    }
    return missing;
}

/// One at a time, so that panels do not wait for it.
void makePlaceholder(NextFrame& next, std::vector<PresetCard>& cards) {
    const auto card = std::ranges::find_if(cards, [](const PresetCard& one) {
        return one.texture == 0 && !one.placeholder && one.fault.empty();
    });
    if (card == cards.end()) return;
    card->placeholder = placeholderOf(card->preset);
    next.again(0.0);
}

void startMaker(Session& session, PresetBrowser& presets) {
    presets.triedThumbnails = true;
    try {
        presets.thumbnails = std::make_unique<ChildProcess>(
            programDir() / "nephoscope", std::vector<std::string>{"thumbnails"},
            ChildProcess::Options{kNiceness, false});
    } catch (const Error& error) {
        session.say(Message::Kind::warning, error.message());
    }
}

}  // namespace

void updateThumbnails(const PanelContext& context, PresetBrowser& presets) {
    const bool images = context.services.loadImage != nullptr;
    const bool missing = images && readThumbnails(context.services, presets);
    makePlaceholder(context.next, presets.cards);
    if (!images) return;
    if (!presets.thumbnails) {
        if (missing && !presets.triedThumbnails) startMaker(context.session(), presets);
        return;
    }
    context.next.again(kLookS);
    if (presets.thumbnails->poll()) return;
    if (presets.thumbnails->status() != 0) {
        context.session().say(
            Message::Kind::warning,
            "The thumbnails of presets could not be made: " + presets.thumbnails->lastWords());
    }
    presets.thumbnails.reset();
}

void keepThumbnails(const Services& services, PresetBrowser& presets,
                    std::vector<PresetCard>& cards) {
    for (PresetCard& card : cards) {
        if (services.loadImage && card.fault.empty()) {
            card.thumbnail = thumbnailFile(card.entry).value_or(std::filesystem::path());
        }
        const auto before =
            std::ranges::find(presets.cards, card.thumbnail, &PresetCard::thumbnail);
        if (before == presets.cards.end() || card.thumbnail.empty()) continue;
        card.texture = std::exchange(before->texture, 0u);
    }
    for (const PresetCard& card : presets.cards) {
        if (card.texture != 0 && services.dropImage) services.dropImage(card.texture);
    }
}

}  // namespace neph::ui
