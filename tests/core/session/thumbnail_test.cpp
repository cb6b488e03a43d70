// thumbnail_test.cpp: thumbnails follow what presets hold.
#include <doctest/doctest.h>

#include <fstream>

#include "core/session/thumbnail.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"

using namespace neph;

TEST_CASE("A thumbnail is named by what the preset holds, wherever it lies") {
    const TemporaryFolder folder;
    const Environment cache("XDG_CACHE_HOME", folder.path().string());
    std::ofstream(folder / "a.json") << "{}";
    std::ofstream(folder / "b.json") << "{}";
    const auto a = thumbnailFile({"a", folder / "a.json", true});
    REQUIRE(a);
    CHECK(a->parent_path() == folder / "nephoscope" / "thumbnails");
    CHECK(a->extension() == ".png");
    CHECK(thumbnailFile({"b", folder / "b.json", false}) == a);
    std::ofstream(folder / "b.json") << "{ }";
    CHECK(thumbnailFile({"b", folder / "b.json", false}) != a);
    CHECK_FALSE(thumbnailFile({"c", folder / "c.json", false}));
}
