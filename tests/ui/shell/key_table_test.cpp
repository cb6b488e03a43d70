// key_table_test.cpp: the table of keys in the manual is that of the program.
#include "app/ui/shell/key_table.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "tests/text.h"

using namespace neph;

TEST_CASE("The manual's table of keys is the one that the program prints") {
    // On a difference: nephoscope keys, into the section "Keys".
    std::ifstream file(NEPH_TEST_SOURCE_DIR "/docs/workbench.md");
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    REQUIRE(contains(manual, "## Keys"));
    CHECK(contains(manual, ui::keyTable()));
}
