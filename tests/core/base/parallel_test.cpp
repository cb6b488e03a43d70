// parallel_test.cpp: what is told of work that fails on one of several threads.
#include "core/base/parallel.h"

#include <doctest/doctest.h>

#include <stdexcept>
#include <thread>

using namespace neph;

TEST_CASE("What failed is told, not that others stopped for it, whichever piece comes first") {
    const Piece work = [](std::size_t piece, std::size_t, const Progress& progress) {
        if (piece == 1) throw std::runtime_error("damaged");
        while (goOn(progress, 0.0)) std::this_thread::yield();
        throw Cancelled{};
    };
    CHECK_THROWS_WITH_AS(shareOut(2, 2, work), "damaged", std::runtime_error);
}

TEST_CASE("Work that is told to stop ends as cancelled") {
    int calls = 0;
    const Progress twice = [&](double) { return ++calls < 3; };
    const Piece work = [](std::size_t, std::size_t, const Progress& progress) {
        if (!goOn(progress, 0.0)) throw Cancelled{};
    };
    CHECK_THROWS_AS(shareOut(100, 1, work, twice), Cancelled);
}
