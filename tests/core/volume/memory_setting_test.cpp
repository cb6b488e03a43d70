// memory_setting_test.cpp: sizes as people write them, control groups, and what is remembered.
#include "core/volume/memory_setting.h"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/session/settings.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

TEST_CASE("A size is read with its unit, a share of what is free, and nothing as no wish") {
    CHECK(parseMemory("2GiB", 0) == 2147483648U);
    CHECK(parseMemory("512 mib", 0) == 536870912U);
    CHECK(parseMemory("1.5G", 0) == 1610612736U);
    CHECK(parseMemory("2000000", 0) == 2000000U);
    CHECK(parseMemory("800MB", 0) == 800000000U);
    CHECK(parseMemory("50%", 4294967296U) == 2147483648U);
    CHECK_FALSE(parseMemory(" ", 0).has_value());
}

TEST_CASE("What is no size is refused with an example") {
    for (const char* text : {"much", "2 bytes", "-1GiB", "150%", "12", "0%", "nan", "1e999GiB"}) {
        CAPTURE(text);
        try {
            parseMemory(text, 4294967296U);
            FAIL_CHECK("was taken");
        } catch (const Error& error) {
            CHECK(contains(error.message(), "512MiB"));
        }
    }
}

TEST_CASE("A control group leaves its limit less what cannot be reclaimed") {
    const TemporaryFolder folder;
    std::ofstream(folder / "memory.max") << "max\n";
    CHECK(controlGroupFreeBytes(folder.path()) == MemoryBudget{}.machine);
    std::ofstream(folder / "memory.max") << "1000\n";
    std::ofstream(folder / "memory.current") << "700\n";
    std::ofstream(folder / "memory.stat") << "anon 500\ninactive_file 200\n";
    CHECK(controlGroupFreeBytes(folder.path()) == 500U);
    std::ofstream(folder / "memory.current") << "2000\n";
    CHECK(controlGroupFreeBytes(folder.path()) == 0U);
}

TEST_CASE("This machine has some memory free, and a quarter of it is taken unless told") {
    const std::uint64_t free = freeMachineBytes();
    CHECK(free > (16U << 20U));
    const MemoryBudget budget = memoryBudget("", 7);
    CHECK(static_cast<double>(budget.machine) ==
          doctest::Approx(static_cast<double>(free) / 4.0).epsilon(0.2));
    CHECK(budget.gpu == 7);
    CHECK(memoryBudget("3MiB", 7).machine == 3145728U);
    CHECK(memoryText(3145728U) == "3 MiB");
    CHECK(memoryText(3328599654U) == "3.1 GiB");
}
