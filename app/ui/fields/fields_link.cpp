// fields_link.cpp: which rows follow, and how.
#include "app/ui/fields/fields_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace neph::ui {
namespace {

/// The row of another field that means the same.
const Parameter& sameRow(const Parameter& row, Species other) {
    return parameter(fmt::format("{}{}", info(other).id, row.id.substr(row.id.find('.'))));
}

float numberIn(const Look& look, const Parameter& row) {
    return std::get<float>(valueOf(look, row));
}

float scaled(const Parameter& row, const Parameter& own, const Look& look, const Look& atPress) {
    const float now = numberIn(look, row), then = numberIn(atPress, row);
    const float ownThen = numberIn(atPress, own);
    const float wanted = then > 0.0f && ownThen > 0.0f ? ownThen * (now / then) : now;
    return std::clamp(wanted, static_cast<float>(own.range.lo), static_cast<float>(own.range.hi));
}

std::array<bool, kSpeciesCount> visibleFields(const Look& look) {
    std::array<bool, kSpeciesCount> visible{};
    for (std::size_t s = 0; s < kSpeciesCount; ++s) visible[s] = look.species[s].visible;
    return visible;
}

void setVisible(Look& look, const std::array<bool, kSpeciesCount>& visible) {
    for (std::size_t s = 0; s < kSpeciesCount; ++s) look.species[s].visible = visible[s];
}

}  // namespace

bool& linkOf(FieldsState& state, Species species) {
    return info(species).liquid ? state.linkLiquid : state.linkIce;
}

bool linkOf(const FieldsState& state, Species species) {
    return info(species).liquid ? state.linkLiquid : state.linkIce;
}

void follow(Look& look, const Look& before, const Look& atPress, Species edited) {
    for (const Parameter& row : lookTable()) {
        if (row.species != edited || row.link == LinkPolicy::own) continue;
        if (valueOf(before, row) == valueOf(look, row)) continue;
        for (int s = 0; s < kSpeciesCount; ++s) {
            const auto other = static_cast<Species>(s);
            if (other == edited || info(other).liquid != info(edited).liquid) continue;
            const Parameter& own = sameRow(row, other);
            if (row.link == LinkPolicy::factor) {
                setValue(look, own, scaled(row, own, look, atPress));
            } else {
                setValue(look, own, valueOf(look, row));
            }
        }
    }
}

bool isSolo(const Look& look, Species species) {
    std::array<bool, kSpeciesCount> alone{};
    alone[static_cast<std::size_t>(species)] = true;
    return visibleFields(look) == alone;
}

void toggleSolo(Session& session, FieldsState& state, Species species) {
    Look& look = session.document.look;
    session.history.commit(session.document);
    if (isSolo(look, species)) {
        std::array<bool, kSpeciesCount>& before = state.beforeSolo;
        if (std::ranges::none_of(before, [](bool visible) { return visible; })) before.fill(true);
        setVisible(look, before);
        session.history.commit(session.document, "All fields as before");
        return;
    }
    bool other =
        true;  // another one's solo goes over to this one, and back to what was before both
    for (int s = 0; s < kSpeciesCount; ++s) other &= !isSolo(look, static_cast<Species>(s));
    if (other) state.beforeSolo = visibleFields(look);
    std::array<bool, kSpeciesCount> alone{};
    alone[static_cast<std::size_t>(species)] = true;
    setVisible(look, alone);
    session.history.commit(session.document, fmt::format("{} alone", info(species).label));
}

}  // namespace neph::ui
