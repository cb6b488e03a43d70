// image_io_test.cpp: images written, read back and refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <type_traits>

#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "core/base/error.h"
#include "core/sky/spectrum.h"
#include "tests/cli/program.h"

using namespace neph;

namespace {

/// Three by two pixels, all different; values that half holds exactly.
ImageF linearImage() {
    ImageF image;
    image.size = {3, 2};
    for (int i = 0; i < 6; ++i) {
        const auto v = static_cast<float>(i);
        image.pixels.emplace_back(v, 0.5f * v, 1000.0f + 8.0f * v, 0.125f * v);
    }
    return image;
}

Image8 displayImage() {
    Image8 image;
    image.size = {3, 2};
    for (int i = 0; i < 24; ++i) image.rgba.push_back(static_cast<std::uint8_t>(10 * i));
    return image;
}

const Metadata kMetadata{{"Software", "Nephoscope"}, {"nephoscope.data", "50 µm, Zürich\nline 2"}};

std::size_t countFiles(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("An EXR reads back pixel for pixel, half and float, with its metadata") {
    const TemporaryFolder folder;
    for (const ExrPixels pixels : {ExrPixels::half, ExrPixels::full}) {
        writeExr(folder / "a.exr", linearImage(), kMetadata, pixels);
        Metadata metadata;
        const ImageF image = readExr(folder / "a.exr", &metadata);
        CHECK(image.size == glm::ivec2(3, 2));
        CHECK(image.pixels == linearImage().pixels);
        for (const auto& entry : kMetadata) {
            CHECK(std::find(metadata.begin(), metadata.end(), entry) != metadata.end());
        }
    }
    CHECK(countFiles(folder.path()) == 1);
}

TEST_CASE("A float EXR keeps what half cannot hold, and half clips to its largest value") {
    const TemporaryFolder folder;
    ImageF image;
    image.size = {1, 1};
    image.pixels = {glm::vec4(1e6f, 1.0f / 3.0f, -1e6f, 1.0f)};
    writeExr(folder / "full.exr", image, {}, ExrPixels::full);
    CHECK(readExr(folder / "full.exr").pixels == image.pixels);
    writeExr(folder / "half.exr", image, {}, ExrPixels::half);
    const glm::vec4 half = readExr(folder / "half.exr").pixels[0];
    CHECK(half.r == 65504.0f);  // largest finite binary16
    CHECK(half.b == -65504.0f);
    CHECK(half.g == doctest::Approx(1.0 / 3.0).epsilon(1.0 / 2048.0));  // 11 bits of mantissa
}

TEST_CASE("Radiance is stored in watts, with units that other programs know, and read back") {
    const TemporaryFolder folder;
    const auto file = folder / "a.exr";
    const auto band = [] {
        return LayeredImage{linearImage(),
                            {{"A.R", {1, 2, 3, 4, 5, 6}, 1},
                             {"variance.R", {1, 2, 3, 4, 5, 6}, 2},
                             {"transmittance", {1, 2, 3, 4, 5, 6}, 0}}};
    };
    writeExr(file, {3, 2}, {}, {ExrPixels::full, true}, {"A.R", "variance.R", "transmittance"},
             band);
    const auto stored = readExrLayers(file, {"A.R", "variance.R", "transmittance", "A"});
    // The sun's 194 W/m² as the eye weighs them, scattered into all directions.
    const double unit = imageUnitWPerM2Sr();
    CHECK(unit == doctest::Approx(15.45).epsilon(0.001));
    CHECK(stored[0][1] == doctest::Approx(2.0 * unit));
    CHECK(stored[1][1] == doctest::Approx(2.0 * unit * unit));
    CHECK(stored[2][1] == 2.0f);
    Metadata metadata;
    const ImageF image = readExr(file, &metadata);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            CHECK(image.pixels[i][c] == doctest::Approx(linearImage().pixels[i][c]));
        }
    }
    CHECK(std::ranges::find(metadata, std::pair<std::string, std::string>(
                                          "radianceUnits", "W m-2 sr-1")) != metadata.end());
}

TEST_CASE("Clipped values are counted") {
    const TemporaryFolder folder;
    ImageF image;
    image.size = {2, 1};
    image.pixels = {glm::vec4(1e4f, 1e4f, 1e3f, 1.0f), glm::vec4(1.0f)};
    CHECK(writeExr(folder / "a.exr", image, {}, {ExrPixels::half, true}) == 2);
    CHECK(writeExr(folder / "a.exr", image, {}, {ExrPixels::full, true}) == 0);
    CHECK(writeExr(folder / "a.exr", image, {}, {ExrPixels::half, false}) == 0);
}

TEST_CASE("Layers of an EXR read back by name, as float beside half, and missing ones are empty") {
    const TemporaryFolder folder;
    const float infinite = std::numeric_limits<float>::infinity();
    const std::vector<float> depth{1e6f, infinite, 1.0f / 3.0f, 0.0f, -1.0f, 1e-30f};
    const std::vector<float> red{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
    for (const ExrPixels pixels : {ExrPixels::half, ExrPixels::full}) {
        std::ptrdiff_t row = 0;
        writeExr(folder / "a.exr", {3, 2}, kMetadata, pixels, {"depth.first_scatter", "A.R"}, [&] {
            const ImageF whole = linearImage();
            const std::ptrdiff_t from = 3 * row++;
            const auto part = [from](const auto& all) {
                return std::decay_t<decltype(all)>(all.begin() + from, all.begin() + from + 3);
            };
            return LayeredImage{{{3, 1}, part(whole.pixels)},
                                {{"depth.first_scatter", part(depth), 0}, {"A.R", part(red), 1}}};
        });
        const auto layers =
            readExrLayers(folder / "a.exr", {"A.R", "none", "depth.first_scatter", "G"});
        REQUIRE(layers.size() == 4);
        CHECK(layers[0] == red);
        CHECK(layers[1].empty());
        CHECK(layers[2] == depth);
        CHECK(layers[3] == std::vector<float>{0.0f, 0.5f, 1.0f, 1.5f, 2.0f, 2.5f});
        CHECK(readExr(folder / "a.exr").pixels == linearImage().pixels);
    }
    CHECK_THROWS_AS(readExrLayers(folder / "missing.exr", {"A.R"}), Error);
}

TEST_CASE("A PNG reads back pixel for pixel, with its metadata, ASCII or not") {
    const TemporaryFolder folder;
    writePng(folder / "a.png", displayImage(), kMetadata);
    const Image8 image = readPng(folder / "a.png");
    CHECK(image.size == glm::ivec2(3, 2));
    CHECK(image.rgba == displayImage().rgba);
    CHECK(readPngMetadata(folder / "a.png") == kMetadata);
    CHECK(countFiles(folder.path()) == 1);
}

TEST_CASE("An image written band by band is the image, and one whose bands fail leaves no file") {
    const TemporaryFolder folder;
    int row = 0;
    const auto next8 = [&] {
        const Image8 whole = displayImage();
        const auto first = whole.rgba.begin() + 12 * row++;
        return Image8{{3, 1}, {first, first + 12}};
    };
    writePng(folder / "a.png", {3, 2}, kMetadata, next8);
    CHECK(readPng(folder / "a.png").rgba == displayImage().rgba);
    for (const ExrPixels pixels : {ExrPixels::half, ExrPixels::full}) {
        row = 0;
        const auto next = [&] {
            const ImageF whole = linearImage();
            const auto first = whole.pixels.begin() + 3 * row++;
            return LayeredImage{{{3, 1}, {first, first + 3}}, {}};
        };
        writeExr(folder / "a.exr", {3, 2}, kMetadata, pixels, {}, next);
        CHECK(readExr(folder / "a.exr").pixels == linearImage().pixels);
    }
    CHECK_THROWS_AS(writePng(folder / "b.png", {3, 2}, {},
                             []() -> Image8 {
                                 throw Error({"", "no more"});
                             }),
                    Error);
    CHECK_THROWS_AS(writeExr(folder / "b.exr", {3, 2}, {}, ExrPixels::half, {},
                             []() -> LayeredImage {
                                 throw Error({"", "no more"});
                             }),
                    Error);
    CHECK(countFiles(folder.path()) == 2);
}

TEST_CASE("A PNG says that it is sRGB, and its first row is the top one") {
    const TemporaryFolder folder;
    writePng(folder / "a.png", displayImage(), {});
    const std::string bytes = readText(folder / "a.png");
    CHECK(bytes.substr(1, 3) == "PNG");
    CHECK(contains(bytes, "sRGB"));
    CHECK(readPng(folder / "a.png").rgba[0] == 0);
    CHECK(readPng(folder / "a.png").rgba[12] == 120);
}

TEST_CASE("A place that cannot be written is an error that names it, and leaves nothing behind") {
    const TemporaryFolder folder;
    const auto missing = folder / "missing";
    CHECK_THROWS_WITH_AS(writePng(missing / "a.png", displayImage(), {}),
                         doctest::Contains("missing/a.png"), Error);
    CHECK_THROWS_WITH_AS(writeExr(missing / "a.exr", linearImage(), {}),
                         doctest::Contains("missing/a.exr"), Error);
    CHECK_THROWS_AS(writePng(folder.path(), displayImage(), {}), Error);
    CHECK(countFiles(folder.path()) == 0);
}

TEST_CASE("Images that are cut short or none at all are refused, wherever they are cut") {
    const TemporaryFolder folder;
    writePng(folder / "a.png", displayImage(), kMetadata);
    writeExr(folder / "a.exr", linearImage(), kMetadata);
    const std::string png = readText(folder / "a.png"), exr = readText(folder / "a.exr");
    for (std::size_t size = 0; size + 12 < png.size(); size += 7) {  // IEND is the last 12 bytes
        std::ofstream(folder / "cut.png", std::ios::binary) << png.substr(0, size);
        CHECK_THROWS_AS(readPng(folder / "cut.png"), Error);
    }
    for (std::size_t size = 0; size < exr.size(); size += 7) {
        std::ofstream(folder / "cut.exr", std::ios::binary) << exr.substr(0, size);
        CHECK_THROWS_AS(readExr(folder / "cut.exr"), Error);
        CHECK_THROWS_AS(readExrLayers(folder / "cut.exr", {"G"}), Error);
    }
    CHECK_THROWS_AS(readPng(folder / "none.png"), Error);
    CHECK_THROWS_AS(readExr(folder / "none.exr"), Error);
    CHECK_THROWS_AS(readPng(folder / "a.exr"), Error);
    CHECK_THROWS_AS(readExr(folder / "a.png"), Error);
}
