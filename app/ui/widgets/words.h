// words.h: what people type, made comparable.
#pragma once
#include <string>
#include <string_view>

namespace neph::ui {

/// With small letters for A to Z; other letters stay.
std::string lower(std::string_view text);

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

/// A number with a point where a decimal comma was typed: "0,5" is 0.5. What could group thousands,
/// as in "1,000", stays, and is then no number.
std::string withDecimalPoint(std::string_view number);

/// Whether every word of `wanted` stands somewhere in `text`, in capitals or not.
bool holdsWords(std::string_view text, std::string_view wanted);

}  // namespace neph::ui
