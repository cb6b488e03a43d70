// fields_state.h: what the fields panel keeps between frames.
#pragma once

namespace neph::ui {

struct FieldsState {};

}  // namespace neph::ui
