// words.cpp: letters of names and of searches.
#include "app/ui/widgets/words.h"

#include <algorithm>

namespace neph::ui {

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return small;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t from = text.find_first_not_of(kBlanks);
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

std::string withDecimalPoint(std::string_view number) {
    std::string text(number);
    const std::size_t comma = text.find(',');
    if (comma == text.npos || text.find_first_of(",.", comma + 1) != text.npos) return text;
    const std::size_t first = text.find_first_of("0123456789.,");
    const std::size_t end = std::min(text.find_first_not_of("0123456789", comma + 1), text.size());
    const std::size_t before = comma - first, after = end - comma - 1;
    const bool thousands = after == 3 && before >= 1 && before <= 3 && text[first] != '0';
    if (!thousands && text.find('.') == text.npos) text[comma] = '.';
    return text;
}

bool holdsWords(std::string_view text, std::string_view wanted) {
    const std::string known = lower(text), words = lower(wanted);
    for (std::size_t from = 0; from < words.size();) {
        const std::size_t to = std::min(words.find(' ', from), words.size());
        if (known.find(words.substr(from, to - from)) == std::string::npos) return false;
        from = to + 1;
    }
    return true;
}

}  // namespace neph::ui
