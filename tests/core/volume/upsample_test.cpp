// upsample_test.cpp: what trilinear interpolation must keep, whatever the sizes.
#include "core/volume/upsample.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

// Of the position in metres; trilinear interpolation is exact for it between cell centres.
double linearField(glm::dvec3 positionM) {
    return 7.0 + 0.5 * positionM.x - 0.25 * positionM.y + 2.0 * positionM.z;
}

SpeciesVolume linearVolume(glm::ivec3 size) {
    SpeciesVolume volume;
    volume.grid = {size, {100.0, -50.0, 20.0}, {4.0, 8.0, 2.0}};
    Array3f& cloud = volume.contentKgPerM3[static_cast<std::size_t>(Species::cloud)];
    cloud = Array3f(size);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                cloud.at(x, y, z) = static_cast<float>(linearField(volume.grid.centreM({x, y, z})));
    return volume;
}

}  // namespace

TEST_CASE("An upsampled volume covers the same domain and follows a linear field between centres") {
    SpeciesVolume volume = linearVolume({5, 4, 3});
    const RegularGrid coarse = volume.grid;
    upsample(volume, {13, 8, 7});
    CHECK(volume.grid.size == glm::ivec3(13, 8, 7));
    CHECK(volume.grid.originM == coarse.originM);
    CHECK(glm::distance(volume.grid.upperM(), coarse.upperM()) < 1e-9);
    const Array3f& cloud = volume.content(Species::cloud);
    REQUIRE(cloud.size == glm::ivec3(13, 8, 7));
    for (int z = 0; z < 7; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 13; ++x) {
                const glm::dvec3 inside =
                    glm::clamp(volume.grid.centreM({x, y, z}), coarse.centreM({0, 0, 0}),
                               coarse.centreM(coarse.size - 1));
                CHECK(cloud.at(x, y, z) == doctest::Approx(linearField(inside)).epsilon(1e-5));
            }
}

TEST_CASE("Upsampling leaves out what is absent and brings extinctions along") {
    SpeciesVolume volume = linearVolume({2, 2, 2});
    volume.extinctionPerM[static_cast<std::size_t>(Species::ice)] = Array3f(glm::ivec3(2), 0.125f);
    upsample(volume, {4, 4, 4});
    CHECK_FALSE(volume.has(Species::rain));
    const Array3f& ice = volume.extinction(Species::ice);
    REQUIRE(ice.values.size() == 64);
    for (const float value : ice.values) CHECK(value == 0.125f);
}

TEST_CASE("A volume that has the size already stays as it is") {
    SpeciesVolume volume = linearVolume({3, 3, 2});
    const std::vector<float> before = volume.content(Species::cloud).values;
    upsample(volume, {3, 3, 2});
    CHECK(volume.content(Species::cloud).values == before);
}
