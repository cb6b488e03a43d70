// fields_link.h: fields that are edited together, and fields that are shown alone.
#pragma once
#include "app/ui/fields/fields_state.h"
#include "core/session/session.h"

namespace neph::ui {

/// Whether fields of the group of `species`, liquid or ice, follow each other.
bool& linkOf(FieldsState& state, Species species);
bool linkOf(const FieldsState& state, Species species);

/// Whether a linked field takes over an edit of this row: sizes and mixing scale by the same
/// factor, phase function, noise, albedo and source of radius by the same value; visibility, colour
/// and density are each field's own.
bool isLinked(const Parameter& row);

/// Gives what differs between `before` and `look` in `edited` to the other fields of its group.
/// Factors are those since `atPress`, so that a drag to a bound and back loses nothing; from zero,
/// where there is no factor, the value itself is given.
void follow(Look& look, const Look& before, const Look& atPress, Species edited);

/// Whether that field alone is visible.
bool isSolo(const Look& look, Species species);
/// Shows that field alone, or where it is, those that were visible before; one step of the history.
void toggleSolo(Session& session, FieldsState& state, Species species);

}  // namespace neph::ui
