// bindings_test.cpp: bindings and locations have names, declared once in shaders/shared for both
// sides. docs/architecture.md
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = NEPH_TEST_SOURCE_DIR;

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Checks that the last group of `use` is `allowed` wherever it occurs under a folder; returns how
/// often it does.
int checkUses(const char* folder, const std::regex& use, const std::regex& allowed) {
    int uses = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
        if (!entry.is_regular_file()) continue;
        const std::string text = textOf(entry.path());
        for (std::sregex_iterator i(text.begin(), text.end(), use), end; i != end; ++i, ++uses) {
            INFO(fs::relative(entry.path(), kRoot).string(), ": ", i->str());
            CHECK(std::regex_search((*i)[i->size() - 1].str(), allowed));
        }
    }
    return uses;
}

}  // namespace

TEST_CASE("No shader spells a binding or a location as a number") {
    CHECK(checkUses("shaders", std::regex(R"(\bbinding\s*=\s*([^,)]*))"),
                    std::regex(R"(^k[A-Z]\w*(Unit|Image|Buffer|Binding)$)")) > 50);
    CHECK(checkUses("shaders", std::regex(R"(\blocation\s*=\s*([^,)]*))"),
                    std::regex(R"(^k[A-Z]\w*Location$)")) > 40);
}

TEST_CASE("The renderer does not spell a binding or a location as a number") {
    const std::regex bind(R"((\.|->)bind\(\s*(GL_\w+,\s*)?(static_cast<GLuint>\()?([^,)]+))");
    // `unit`: where the name is the caller's.
    CHECK(checkUses("app/render", bind,
                    std::regex(R"(^((block::)?k[A-Z]\w*(Unit|Buffer|Binding)\b|unit$))")) > 40);
    CHECK(checkUses("app/render", std::regex(R"((\.|->)bindImage\(\s*([^,]+))"),
                    std::regex(R"(^k[A-Z]\w*Image$)")) > 20);
    CHECK(checkUses("app/render", std::regex(R"((\.|->)set(Int|Float|Vec3)\(\s*([^,]+))"),
                    std::regex(R"(^k[A-Z]\w*Location\b)")) > 40);
}
