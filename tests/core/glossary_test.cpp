// glossary_test.cpp: documentation and texts of the program use no word that docs/glossary.md
// retired. That page says how its table is read.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = NEPH_TEST_SOURCE_DIR;

struct Text {
    int line;
    std::string text;
    bool path = false;  ///< of a literal: joined to a path by /
};

std::string readFile(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    REQUIRE(stream);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == at) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \t\r");
    if (from == std::string::npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

/// Entries of the third column that are neither in italics nor code.
std::vector<std::string> retiredWords(const std::string& glossary) {
    std::vector<std::string> words;
    for (const std::string& line : split(glossary, '\n')) {
        const std::vector<std::string> cells = split(line, '|');
        if (cells.size() < 5 || trimmed(cells[3]) == "retired") continue;
        for (const std::string& entry : split(cells[3], ',')) {
            const std::string word = trimmed(entry);
            if (!word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
                words.push_back(word);
            }
        }
    }
    return words;
}

/// Matches each of `words` as a whole word; parts of ids (export.picture, --error-picture) are
/// none.
std::regex anyOf(const std::vector<std::string>& words) {
    std::string alternatives;
    for (const std::string& word : words) {
        if (!alternatives.empty()) alternatives += '|';
        alternatives += word.starts_with("N ") ? "[0-9}]" + word.substr(1) : word;
    }
    return std::regex(R"((?:^|[^\w.-])()" + alternatives + R"()(?![\w-]|\.\w))",
                      std::regex::icase | std::regex::ECMAScript);
}

/// Prose of a Markdown page: code becomes blank, link targets go.
std::vector<Text> proseOf(const std::string& markdown) {
    static const std::regex code(R"(`[^`]*`)"), target(R"(\]\([^)]*\))");
    std::vector<Text> prose;
    bool fenced = false;
    int number = 0;
    for (const std::string& line : split(markdown, '\n')) {
        ++number;
        if (trimmed(line).starts_with("```")) {
            fenced = !fenced;
        } else if (!fenced) {
            prose.push_back(
                {number, std::regex_replace(std::regex_replace(line, code, "``"), target, "]")});
        }
    }
    return prose;
}

/// Finds string literals in C++. Adjacent ones become one, escapes become spaces.
class Literals {
  public:
    explicit Literals(const std::string& source) : source_(source) {}

    std::vector<Text> take() {
        while (at_ < source_.size()) next();
        return std::move(found_);
    }

  private:
    bool ahead(std::string_view text) const { return source_.compare(at_, text.size(), text) == 0; }
    void skip(std::size_t end) {
        end = std::min(end, source_.size());
        line_ +=
            static_cast<int>(std::count(source_.begin() + static_cast<std::ptrdiff_t>(at_),
                                        source_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        at_ = end;
    }
    void next() {
        if (ahead("//") || ahead("#include")) {
            skip(source_.find('\n', at_));
        } else if (ahead("/*")) {
            skip(source_.find("*/", at_) + 2);
        } else if (ahead("R\"")) {
            raw();
        } else if (ahead("\"")) {
            plain();
        } else if (ahead("'") &&
                   (at_ == 0 || std::isalnum(static_cast<unsigned char>(source_[at_ - 1])) == 0)) {
            skip(source_.find('\'', at_ + (source_[at_ + 1] == '\\' ? 3 : 1)) + 1);
        } else {
            joins_ = joins_ && std::isspace(static_cast<unsigned char>(source_[at_])) != 0;
            skip(at_ + 1);
        }
    }
    void raw() {
        const std::size_t open = source_.find('(', at_);
        const std::string end = ")" + source_.substr(at_ + 2, open - at_ - 2) + "\"";
        const std::size_t close = source_.find(end, open);
        add(source_.substr(open + 1, close - open - 1));
        skip(close + end.size());
    }
    void plain() {
        std::string text;
        std::size_t i = at_ + 1;
        for (; source_.at(i) != '"'; ++i) {
            if (source_[i] == '\\') {
                text += ' ';
                i += source_[i + 1] == 'u' ? 5 : 1;
            } else {
                text += source_[i];
            }
        }
        add(text);
        skip(i + 1);
    }
    void add(const std::string& text) {
        if (joins_) {
            found_.back().text += text;
        } else {
            const std::size_t before = source_.find_last_not_of(" \n", at_ - 1);
            found_.push_back(
                {line_, text, at_ > 0 && before != std::string::npos && source_[before] == '/'});
        }
        joins_ = true;
    }

    std::string source_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool joins_ = false;  ///< whether only blanks followed the last literal
    std::vector<Text> found_;
};

/// Literals that a user may read: what ImGui hides after ## is cut off, ids are left out.
std::vector<Text> readableLiterals(const std::string& source) {
    std::vector<Text> readable;
    for (Text& literal : Literals(source).take()) {
        const std::string text = trimmed(literal.text.substr(0, literal.text.find("##")));
        if (text.empty() || literal.path) continue;
        const bool isWord = text.find(' ') == std::string::npos;
        const bool isId = isWord && (std::isupper(static_cast<unsigned char>(text.front())) == 0 ||
                                     text.find_first_of("._-") < text.size() - 1);
        if (!isId) readable.push_back({literal.line, literal.text});
    }
    return readable;
}

/// One line for each retired word: file, line, word.
std::string findRetired(const fs::path& file, const std::vector<Text>& texts,
                        const std::regex& retired) {
    std::string report;
    for (const Text& text : texts) {
        for (std::sregex_iterator hit(text.text.begin(), text.text.end(), retired), end; hit != end;
             ++hit) {
            report += "\n" + fs::relative(file, kRoot).string() + ":" + std::to_string(text.line) +
                      ": " + hit->str(1);
        }
    }
    return report;
}

std::regex retiredPattern() {
    const std::vector<std::string> words = retiredWords(readFile(kRoot / "docs/glossary.md"));
    REQUIRE(words.size() > 20);
    return anyOf(words);
}

std::vector<fs::path> pages() {
    std::vector<fs::path> found{kRoot / "README.md", kRoot / "CONTRIBUTING.md",
                                kRoot / "CHANGELOG.md"};
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "docs")) {
        const bool page = entry.path().extension() == ".md";
        if (page && entry.path().filename() != "glossary.md") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<fs::path> sources() {
    std::vector<fs::path> found;
    for (const char* room : {"app", "core", "readers"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / room)) {
            const std::string kind = entry.path().extension();
            if (kind == ".h" || kind == ".cpp" || kind == ".inc") found.push_back(entry.path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

TEST_CASE("Retired words are the plain entries of the glossary's third column") {
    const std::vector<std::string> words = retiredWords(
        "| term | meaning | retired |\n|---|---|---|\n| image | pixels | picture, *turn*, `way` |\n"
        "| rate | | N a pixel |\n");
    CHECK(words == std::vector<std::string>{"picture", "N a pixel"});
    const std::regex retired = anyOf(words);
    CHECK(std::regex_search("A Picture, in words.", retired));
    CHECK(std::regex_search("{} a pixel", retired));
    CHECK_FALSE(std::regex_search("pictures, --error-picture, export.picture, picture.png, a pixel",
                                  retired));
}

TEST_CASE("Prose of a page is what is outside code and link targets") {
    const std::vector<Text> prose = proseOf("See `a.h` and [b](c.md).\n```\ncode\n```\nEnd.");
    REQUIRE(prose.size() == 2);
    CHECK(prose[0].text == "See `` and [b].");
    CHECK(prose[1].line == 5);
}

TEST_CASE("Literals that a user may read are found, and comments, includes and ids are not") {
    const std::vector<Text> texts = readableLiterals(
        "#include \"a b.h\"\n// \"c d\"\nf('\"', 1'000, \"one \"\n  \"two\\n\", \"some.id\", "
        "\"word\",\n \"Label###id\", home / \"Pictures\", R\"(raw \"text\")\");");
    REQUIRE(texts.size() == 3);
    CHECK(texts[0].text == "one two ");
    CHECK(texts[0].line == 3);
    CHECK(texts[1].text == "Label###id");
    CHECK(texts[2].text == "raw \"text\"");
    CHECK(texts[2].line == 5);
}

TEST_CASE("Documentation uses no retired word") {
    const std::regex retired = retiredPattern();
    for (const fs::path& page : pages()) {
        const std::string report = findRetired(page, proseOf(readFile(page)), retired);
        CHECK_MESSAGE(report.empty(), report);
    }
}

TEST_CASE("Texts of the program use no retired word") {
    const std::regex retired = retiredPattern();
    for (const fs::path& source : sources()) {
        const std::string report = findRetired(source, readableLiterals(readFile(source)), retired);
        CHECK_MESSAGE(report.empty(), report);
    }
}
