// fuzz_ini.cpp: any text is an .ini file.
#include "readers/raw_les/ini.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    raw::parseIni(fuzz::asText({bytes, count}));
    return 0;
}
