// compare_test.cpp: `nephoscope compare` on images whose errors are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "tests/cli/program.h"

using namespace neph;

namespace {

constexpr glm::ivec2 kSize(96, 64);
constexpr int kPixels = kSize.x * kSize.y;

/// Radiance of mean 1, alike in all channels.
ImageF truth(float factor = 1.0f) {
    ImageF image;
    image.size = kSize;
    for (int i = 0; i < kPixels; ++i) {
        const float value = 0.5f + (static_cast<float>(i) + 0.5f) / kPixels;
        image.pixels.emplace_back(glm::vec3(factor * value), 1.0f);
    }
    return image;
}

std::vector<ImageLayer> layersOf(const ImageF& half, const std::string& name) {
    std::vector<ImageLayer> layers{{name + ".R", {}}, {name + ".G", {}}, {name + ".B", {}}};
    for (const glm::vec4& pixel : half.pixels) {
        for (std::size_t c = 0; c < 3; ++c) layers[c].values.push_back(pixel[static_cast<int>(c)]);
    }
    return layers;
}

/// The truth with grey noise of this deviation, and its halves.
void writeNoisy(const std::filesystem::path& file, double deviation) {
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0f, static_cast<float>(deviation * std::sqrt(2.0)));
    ImageF a = truth(), b = truth(), mean = truth();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        a.pixels[i] += glm::vec4(glm::vec3(noise(random)), 0.0f);
        b.pixels[i] += glm::vec4(glm::vec3(noise(random)), 0.0f);
        mean.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
    }
    std::vector<ImageLayer> layers = layersOf(a, "A");
    for (ImageLayer& layer : layersOf(b, "B")) layers.push_back(std::move(layer));
    std::vector<std::string> names;
    for (const ImageLayer& layer : layers) names.push_back(layer.name);
    writeExr(file, kSize, {}, ExrPixels::full, names, [&] { return LayeredImage{mean, layers}; });
}

Image8 grey(int value) {
    Image8 image;
    image.size = kSize;
    for (int i = 0; i < kPixels; ++i) {
        for (int c = 0; c < 4; ++c) {
            image.rgba.push_back(static_cast<std::uint8_t>(c == 3 ? 255 : value));
        }
    }
    return image;
}

std::string quoted(const std::filesystem::path& file) {
    return " '" + file.string() + "'";
}

}  // namespace

TEST_CASE("The error of an image is found below the reference's noise, from the halves it keeps") {
    const TemporaryFolder folder;
    writeExr(folder / "a.exr", truth(1.05f), {}, ExrPixels::full);
    writeNoisy(folder / "b.exr", 0.2);
    const Outcome outcome =
        runProgram("compare --json" + quoted(folder / "a.exr") + quoted(folder / "b.exr"));
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["type"] == "nephoscope-comparison");
    CHECK(json["reference"]["halves"] == true);
    const auto& errors = json["images"][0];
    const double rmse = 0.05 * std::sqrt(1.0 + 1.0 / 12.0);  // √mean truth² of mean 1
    const double sigma = errors["rel_rmse_sigma"].get<double>();
    CHECK(std::abs(errors["rel_rmse"].get<double>() - rmse) < 3.0 * sigma);
    CHECK(sigma < rmse);
    CHECK(errors["rel_rmse_with_noise"].get<double>() > 3.0 * rmse);
    CHECK(errors["noise_taken_off"].get<double>() == doctest::Approx(0.2).epsilon(0.05));
    CHECK(std::abs(errors["bias"].get<double>() - 0.05) < 3.0 * errors["bias_sigma"].get<double>());
    CHECK(errors["flip"]["kind"] == "HDR-FLIP");
}

TEST_CASE("The table tells all figures with what they mean, and images of errors are written") {
    const TemporaryFolder folder;
    writeExr(folder / "a.exr", truth(1.1f), {{"nephoscope.camera", "azimuth 10"}}, ExrPixels::full);
    writeExr(folder / "b.exr", truth(),
             {{"nephoscope.renderer", "reference, of a test"}, {"nephoscope.camera", "azimuth 20"}},
             ExrPixels::full);
    const std::string both = quoted(folder / "a.exr") + quoted(folder / "b.exr");
    const Outcome outcome =
        runProgram("compare" + both + " --signed --error-to 20 --error-image" +
                   quoted(folder / "error.png") + " --flip-image" + quoted(folder / "flip.png"));
    REQUIRE(outcome.status == 0);
    for (const char* words : {"bias", "relRMSE", "relMSE", "p95", "HDR-FLIP", "10 %",
                              "reference, of a test", "nothing has halves"}) {
        CAPTURE(words);
        CHECK(contains(outcome.out, words));
    }
    CHECK(contains(outcome.err, "differ in their camera: azimuth 10; azimuth 20"));
    const Image8 error = readPng(folder / "error.png");
    CHECK(error.size.y > kSize.y);         // with a legend
    CHECK(error.rgba[0] > error.rgba[2]);  // too bright is red
    CHECK(readPng(folder / "flip.png").size == error.size);
    CHECK(contains(runProgram("compare --exposure 1" + both).out, "as ACES: 1 EV\n"));
}

TEST_CASE("Images of a screen are compared as decoded light, and said to be so") {
    const TemporaryFolder folder;
    writePng(folder / "a.png", grey(188), {});
    writePng(folder / "b.png", grey(128), {});
    const Outcome outcome =
        runProgram("compare" + quoted(folder / "a.png") + quoted(folder / "b.png"));
    REQUIRE(outcome.status == 0);
    CHECK(contains(outcome.out, "LDR-FLIP"));
    CHECK(contains(outcome.out, "colours of a screen"));
    const auto json = nlohmann::json::parse(
        runProgram("compare --json" + quoted(folder / "a.png") + quoted(folder / "b.png")).out);
    // sRGB 188 and 128 are 0.5029 and 0.2159 of linear white. IEC 61966-2-1
    CHECK(json["images"][0]["bias"].get<double>() ==
          doctest::Approx(0.5029 / 0.2159 - 1.0).epsilon(1e-3));
}

TEST_CASE("What cannot be compared is refused, with the exit status of its kind") {
    const TemporaryFolder folder;
    writeExr(folder / "a.exr", truth(), {});
    writePng(folder / "a.png", grey(1), {});
    ImageF small = truth();
    small.size = {kSize.x / 2, kSize.y * 2};
    writeExr(folder / "small.exr", small, {});
    const auto check = [&](const std::string& arguments, int status, const char* says) {
        CAPTURE(arguments);
        const Outcome outcome = runProgram("compare " + arguments);
        CHECK(outcome.status == status);
        CHECK(contains(outcome.err, says));
    };
    const std::string exr = quoted(folder / "a.exr");
    check(exr + quoted(folder / "small.exr"), 1, "96x64 and 48x128");
    check(exr + quoted(folder / "a.png"), 1, "two images of one kind");
    check(exr + quoted(folder / "none.exr"), 1, "none.exr");
    check(exr, 2, "two images");
    check(exr + exr + " --out x", 2, "--error-image");
    check(exr + exr + " --error-image x.jpg", 2, "NAME.png");
    check(exr + exr + " --error-to 0", 2, "above 0");
    check(exr + exr + " --exposure bright", 2, "a number");
    check("a.tiff b.tiff", 2, ".exr or .png");
}

TEST_CASE("Lists of engines are checked before anything is drawn") {
    struct Case {
        const char* engines;
        const char* says;
    };
    for (const Case& c :
         {Case{"march", "nothing to compare with"}, Case{"march,warp", "one of march, slicing"},
          Case{"march:light.fom=printed,slicing", "light.form?"},
          Case{"march:view.planes=1,slicing", "from 16 to 2048"},
          Case{"march:cloud.radius_source=file,slicing", "the same data"}}) {
        CAPTURE(c.engines);
        const Outcome outcome = runProgram(std::string("compare --engine ") + c.engines);
        CHECK(outcome.status == 2);
        CHECK(contains(outcome.err, c.says));
    }
    CHECK(contains(runProgram("compare --engine march,slicing --error-image x.png").err,
                   "--out FOLDER"));
}

TEST_CASE("Engines draw one view, the last is the reference, and all of it is kept") {
    const TemporaryFolder folder;
    const Outcome outcome = runProgram(
        "compare --json --engine march,slicing:light.form=consistent --engine reference "
        "--size 12x8 --planes 32 --samples 4 --seed 5 --set view.light_voxels=1000 --out" +
        quoted(folder / "kept"));
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    REQUIRE(json["images"].size() == 2);
    CHECK(json["images"][0]["name"] == "march");
    CHECK(json["images"][1]["name"] == "slicing:light.form=consistent");
    CHECK(json["reference"]["halves"] == true);
    CHECK(json["reference"]["samples"] == 4);
    CHECK(json["reference"]["seconds"].get<double>() > 0.0);
    CHECK_FALSE(json["reference"]["device"].get<std::string>().empty());
    CHECK(contains(json["reference"]["made"].get<std::string>(), "reference, 4 paths"));
    for (const char* name : {"march.exr", "march.png", "march-error.png", "march-flip.png",
                             "slicing-light.form-consistent.exr", "reference.png"}) {
        CAPTURE(name);
        CHECK(std::filesystem::exists(folder / "kept" / name));
    }
    // The same figures come of the files.
    const auto again =
        nlohmann::json::parse(runProgram("compare --json" + quoted(folder / "kept" / "march.exr") +
                                         quoted(folder / "kept" / "reference.exr"))
                                  .out);
    for (const char* figure : {"bias", "rel_rmse", "noise_taken_off", "rel_mse", "p95"}) {
        CAPTURE(figure);
        CHECK(again["images"][0][figure].get<double>() ==
              doctest::Approx(json["images"][0][figure].get<double>()));
    }
}

TEST_CASE("The reference's EXR has halves that make the image, and depths that make its opacity") {
    const TemporaryFolder folder;
    const auto file = folder / "a.exr";
    REQUIRE(runProgram("render --engine reference --size 16x9 --samples 4 --format float --out" +
                       quoted(file))
                .status == 0);
    Metadata metadata;
    const ImageF image = readExr(file, &metadata);
    const float unit = imageUnitOfExr(metadata);
    CHECK(1.0 / static_cast<double>(unit) == doctest::Approx(15.45).epsilon(0.001));  // W m⁻² sr⁻¹
    const auto layers =
        readExrLayers(file, {"A.G", "B.G", "variance.G", "transmittance", "depth.first_scatter",
                             "optical_depth.cloud", "optical_depth.ice", "optical_depth.rain",
                             "optical_depth.snow", "optical_depth.graupel", "optical_depth.hail"});
    for (const auto& layer : layers) REQUIRE(layer.size() == image.pixels.size());
    int cloudy = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        CAPTURE(i);
        const float mean = 0.5f * unit * (layers[0][i] + layers[1][i]);
        CHECK(mean == doctest::Approx(image.pixels[i].g).epsilon(1e-4));
        CHECK(layers[2][i] >= 0.0f);
        float depth = 0.0f;
        for (std::size_t s = 5; s < layers.size(); ++s) depth += layers[s][i];
        CHECK(layers[3][i] == doctest::Approx(std::exp(-depth)).epsilon(0.02));
        CHECK(layers[4][i] > 0.0f);
        if (depth > 1.0f) ++cloudy;
    }
    CHECK(cloudy > 5);
}

TEST_CASE("A denoised preview keeps the halves and says what it is") {
    const TemporaryFolder folder;
    const auto plain = folder / "plain.exr", preview = folder / "preview.exr";
    const std::string traced =
        "render cumulus --engine reference --size 12x8 --samples 2 --format float ";
    REQUIRE(runProgram(traced + "--out " + quoted(plain)).status == 0);
    const Outcome denoised = runProgram(traced + "--denoise --out " + quoted(preview));
    REQUIRE_MESSAGE(denoised.status == 0, denoised.err);
    CHECK(contains(denoised.err, "denoised preview"));
    const std::vector<std::string> halves{"A.R", "A.G", "A.B", "B.R", "B.G", "B.B"};
    CHECK(readExrLayers(plain, halves) == readExrLayers(preview, halves));
    Metadata metadata;
    CHECK(readExr(preview, &metadata).pixels != readExr(plain).pixels);
    CHECK(std::ranges::any_of(metadata, [](const auto& entry) {
        return entry.first == "nephoscope.denoised" && contains(entry.second, "denoised preview");
    }));
}

TEST_CASE("A denoised preview is not compared, on either side") {
    const TemporaryFolder folder;
    const Metadata marked{{"nephoscope.denoised", "denoised preview"}};
    writeExr(folder / "plain.exr", truth(), {});
    writeExr(folder / "preview.exr", truth(), marked);
    writePng(folder / "plain.png", grey(90), {});
    writePng(folder / "preview.png", grey(90), marked);
    for (const std::string ending : {".exr", ".png"}) {
        const std::string plain = quoted(folder / ("plain" + ending)) + " ";
        const std::string preview = quoted(folder / ("preview" + ending)) + " ";
        CHECK(runProgram("compare " + plain + plain).status == 0);
        for (const std::string& files : {preview + plain, plain + preview}) {
            const Outcome refused = runProgram("compare " + files);
            CHECK(refused.status == 1);
            CHECK(contains(refused.err, "without --denoise"));
        }
    }
}
