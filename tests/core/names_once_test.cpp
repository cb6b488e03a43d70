// names_once_test.cpp: no two types, constants or inline functions of one name in one namespace,
// read from the sources themselves. The linker takes either of two in silence: what one file made
// by its definition, another reads by the other.
//
// A reader of its own for what the scan needs: namespaces, and what opens or ends a statement in
// them. Whatever an unnamed namespace of a .cpp holds is that file's alone.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = NEPH_TEST_SOURCE_DIR;

/// Name with its namespaces, and the files that define it.
using Definitions = std::map<std::string, std::set<std::string>>;

/// Where `from` is opened by a comment, a literal or a directive, the place behind it.
std::size_t behindNoise(const std::string& text, std::size_t from) {
    const auto behind = [&](std::string_view end, std::size_t start) {
        const std::size_t found = text.find(end, start);
        return found == text.npos ? text.size() : found + end.size();
    };
    const std::string_view rest = std::string_view(text).substr(from);
    if (rest.starts_with("//")) return behind("\n", from) - 1;
    if (rest.starts_with("/*")) return behind("*/", from + 2);
    if (rest.starts_with("R\"(")) return behind(")\"", from + 3);
    const char quote = rest[0];
    if (quote == '#' && (from == 0 || text[from - 1] == '\n')) {
        std::size_t end = behind("\n", from);
        while (end >= 2 && end < text.size() && text[end - 2] == '\\') end = behind("\n", end);
        return end;
    }
    // 1'000 is a number.
    const bool digits = quote == '\'' && from > 0 && std::isalnum(text[from - 1]) != 0;
    if ((quote != '"' && quote != '\'') || digits) return from;
    std::size_t at = from + 1;
    while (at < text.size() && text[at] != quote) at += text[at] == '\\' ? 2 : 1;
    return at + 1;
}

std::string withoutNoise(const std::string& text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t next = behindNoise(text, at);
        plain += next == at ? text[at] : ' ';
        at = next == at ? at + 1 : next;
    }
    return plain;
}

/// What a statement before '{' or ';' defines, if it is a type, a constant or an inline function.
std::optional<std::string> definedBy(const std::string& statement, char end) {
    static const std::regex type(
        R"(^\s*(?:template\s*<[^{}]*>\s*)?(?:struct|class|union|enum|enum class|enum struct)\s+)"
        R"((\w+)\s*(?:final\s*)?(?::[^:][^]*)?$)");
    static const std::regex constant(
        R"(^\s*(?:inline\s+|extern\s+)?(?:constexpr|const)\s[^=()]*?\b(k[A-Z]\w*)\s*(?:=|\[|$))");
    static const std::regex function(R"(^\s*(?:inline|constexpr)\b[^=]*?\b(\w+)\s*(\([^]*\)).*$)");
    std::smatch match;
    if (end == '{' && std::regex_search(statement, match, type)) return match[1];
    if (std::regex_search(statement, match, constant)) return match[1];
    if (end == '{' && std::regex_search(statement, match, function)) {
        return std::regex_replace(match.str(1) + match.str(2), std::regex(R"(\s+)"), " ");
    }
    return {};
}

class Reader {
  public:
    Reader(std::string file, Definitions& definitions)
        : file_(std::move(file)), definitions_(definitions) {}

    void read(const std::string& text) {
        for (const char c : withoutNoise(text)) {
            if (c == '{') {
                open();
            } else if (c == '}') {
                if (!spaces_.empty()) spaces_.pop_back();
            } else if (c == ';') {
                note(c);
            } else {
                statement_ += c;
                continue;
            }
            statement_.clear();
        }
    }

  private:
    void open() {
        static const std::regex space(R"(^\s*(?:inline\s+)?namespace\s*([\w:]*)\s*$)");
        std::smatch match;
        if (std::regex_search(statement_, match, space)) {
            spaces_.push_back(match[1]);
        } else if (std::regex_match(statement_, std::regex(R"(\s*extern\s*)"))) {  // "C"
            spaces_.emplace_back(kTransparent);
        } else {
            note('{');
            spaces_.emplace_back(kBlock);
        }
    }

    void note(char end) {
        std::string scope;
        for (const std::string& space : spaces_) {
            if (space == kBlock || space.empty()) return;
            if (space != kTransparent) scope += space + "::";
        }
        if (const auto name = definedBy(statement_, end)) definitions_[scope + *name].insert(file_);
    }

    static constexpr std::string_view kBlock = "{", kTransparent = "extern";

    std::string file_;
    Definitions& definitions_;
    std::vector<std::string> spaces_;  ///< names, empty where there is none; or one of the above
    std::string statement_;
};

void readText(const std::string& file, const std::string& text, Definitions& definitions) {
    Reader(file, definitions).read(text);
}

void readRoom(const std::string& room, Definitions& definitions) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / room)) {
        const std::string kind = entry.path().extension();
        if (kind != ".h" && kind != ".cpp") continue;
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        readText(fs::relative(entry.path(), kRoot).string(), text, definitions);
    }
}

void checkOnce(const Definitions& definitions) {
    for (const auto& definition : definitions) {
        const auto& files = definition.second;
        CAPTURE(definition.first);
        CAPTURE(*files.begin());
        CAPTURE(*files.rbegin());
        CHECK(files.size() == 1);
    }
}

}  // namespace

TEST_CASE("The scan for names sees types, constants and inline functions of named namespaces") {
    Definitions seen;
    readText("a.h", R"(namespace a { enum class Kind { one }; struct Other; inline int f(int x) {
        return x; } inline constexpr int kMost = 3; namespace { struct Own {}; } })",
             seen);
    readText("b.cpp", R"(// struct Kind {
        namespace a { struct Kind : Base { int kMost = 1; struct Inner {}; }; namespace {
        struct Own {}; } int f(int x) { return x; } } namespace a::b { struct Kind final {}; })",
             seen);
    CHECK(seen["a::Kind"] == std::set<std::string>{"a.h", "b.cpp"});
    CHECK(seen["a::b::Kind"] == std::set<std::string>{"b.cpp"});
    CHECK(seen["a::kMost"] == std::set<std::string>{"a.h"});
    CHECK(seen["a::f(int x)"] == std::set<std::string>{"a.h"});
    CHECK(seen.size() == 4);
}

TEST_CASE("No name is defined twice in one namespace of the program") {
    Definitions definitions;
    readRoom("core", definitions);
    readRoom("app", definitions);
    CHECK(definitions.size() > 350);
    checkOnce(definitions);
}

TEST_CASE("No name is defined twice in one namespace of a reader or of the program of a test") {
    for (const char* parent : {"readers", "tests"}) {
        for (const auto& entry : fs::directory_iterator(kRoot / parent)) {
            if (!entry.is_directory()) continue;
            const std::string room = fs::relative(entry.path(), kRoot).string();
            if (room == "tests/fuzz") continue;  // a program of each file
            Definitions definitions;
            readRoom(room, definitions);
            // A library of its own, as tests/CMakeLists.txt has it.
            if (room == "tests/readers") definitions.erase("NephFile");
            checkOnce(definitions);
        }
    }
}
