// volume_cache_test.cpp: the least recently used goes first, and nothing beyond the bound stays.
#include "core/volume/volume_cache.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

VolumeKey keyOf(int index) {
    return {index, std::string("a"), {}};
}

std::shared_ptr<const HeldVolume> volumeOf(int cells) {
    SpeciesVolume volume;
    volume.contentKgPerM3[0] = Array3f(glm::ivec3(cells, 1, 1));
    HeldVolume held;
    held.volume = std::make_shared<const SpeciesVolume>(std::move(volume));
    return std::make_shared<const HeldVolume>(std::move(held));
}

constexpr std::uint64_t kCellBytes = sizeof(float);

}  // namespace

TEST_CASE("What was used last stays when memory is short") {
    VolumeCache cache;
    cache.setLimit(30 * kCellBytes);
    for (int i = 0; i < 3; ++i) cache.put(keyOf(i), volumeOf(10));
    CHECK(cache.bytes() == 30 * kCellBytes);
    CHECK(cache.find(keyOf(0)) != nullptr);
    cache.put(keyOf(3), volumeOf(10));
    CHECK(cache.holds(keyOf(0)));
    CHECK_FALSE(cache.holds(keyOf(1)));
    CHECK(cache.bytes() == 30 * kCellBytes);
}

TEST_CASE("The newest volume stays however large, and what was taken lives on beyond the cache") {
    VolumeCache cache;
    cache.setLimit(5 * kCellBytes);
    const auto first = volumeOf(10);
    cache.put(keyOf(0), first);
    CHECK(cache.count() == 1);
    cache.put(keyOf(1), volumeOf(20));
    CHECK(cache.count() == 1);
    CHECK(cache.bytes() == 20 * kCellBytes);
    CHECK(first->volume->bytes() == 10 * kCellBytes);
}

TEST_CASE("Putting a key again replaces its volume") {
    VolumeCache cache;
    cache.put(keyOf(0), volumeOf(10));
    cache.put(keyOf(0), volumeOf(3));
    CHECK(cache.count() == 1);
    CHECK(cache.bytes() == 3 * kCellBytes);
    cache.clear();
    CHECK(cache.bytes() == 0);
}

TEST_CASE("Another region, budget or sizing of particles is another volume") {
    VolumeCache cache;
    cache.put(keyOf(0), volumeOf(1));
    VolumeKey key = keyOf(0);
    key.request.region = BoxM{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    CHECK_FALSE(cache.holds(key));
    key = keyOf(0);
    key.request.budget.machine = 1;
    CHECK_FALSE(cache.holds(key));
    key = keyOf(0);
    key.request.radii.rules[0].source = RadiusSource::file;
    CHECK_FALSE(cache.holds(key));
}

TEST_CASE("A volume that was read with humidity serves a key without, and replaces the other") {
    VolumeCache cache;
    const VolumeKey without = keyOf(0), with = withHumidity(keyOf(0), true);
    cache.put(without, volumeOf(10));
    CHECK(cache.find(with) == nullptr);
    const auto humid = volumeOf(10);
    cache.put(with, humid);
    CHECK(cache.count() == 1);
    CHECK(cache.bytes() == 10 * kCellBytes);
    CHECK(cache.find(with) == humid);
    CHECK(cache.find(without) == humid);
    CHECK_FALSE(cache.holds(withHumidity(keyOf(1), false)));
}
