// fuzz_file_kind.cpp: any file is of a kind or of none, and the same when it is asked again.
#include <cstdlib>

#include "core/plugin/file_kind.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const std::filesystem::path file = scratch.write("a", fuzz::asText({bytes, count}));
    const auto known = neph::recogniseFile(file);
    const auto again = neph::recogniseFile(file);
    if (known.has_value() != again.has_value()) std::abort();
    if (known && (known->what != again->what || known->step.empty())) std::abort();
    return 0;
}
