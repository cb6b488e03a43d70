// fields_link.h: fields that are edited together, and fields that are shown alone.
#pragma once
#include "app/ui/fields/fields_state.h"
#include "core/session/session.h"

namespace neph::ui {

/// Whether fields of the group of `species`, liquid or ice, follow each other.
bool& linkOf(FieldsState& state, Species species);
bool linkOf(const FieldsState& state, Species species);

/// Gives what differs between `before` and `look` in `edited` to the other fields of its group, as
/// the rows' link policies say.
/// Factors are those since `atPress`, so that a drag to a bound and back loses nothing; from zero,
/// where there is no factor, the value itself is given.
void follow(Look& look, const Look& before, const Look& atPress, Species edited);

/// Whether that field alone is visible.
bool isSolo(const Look& look, Species species);
/// Shows that field alone, or where it is, those that were visible before; one step of the history.
void toggleSolo(Session& session, FieldsState& state, Species species);

}  // namespace neph::ui
