// error.cpp: the layout of an error message: what is wrong, then found, expected and hint,
// indented.
#include "core/base/error.h"

#include <fmt/format.h>

namespace neph {
namespace {

std::string layout(const ErrorParts& parts) {
    std::string text = parts.where.empty() ? parts.what : parts.where + ": " + parts.what;
    if (!parts.found.empty()) text += "\n       found: " + parts.found;
    if (!parts.expected.empty()) {
        text += (parts.found.empty() ? "\n       " : "   ") + ("expected: " + parts.expected);
    }
    if (!parts.hint.empty()) text += "\n       hint: " + parts.hint;
    return text;
}

}  // namespace

Error::Error(ErrorParts parts) : std::runtime_error(layout(parts)), parts_(std::move(parts)) {}

}  // namespace neph
