// fuzz_ini.cpp: any text is an .ini file, and a namelist.
#include "readers/raw_les/cm1.h"
#include "readers/raw_les/ini.h"
#include "readers/raw_les/microhh_names.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = fuzz::asText({bytes, count});
    raw::hydrometeorsOf(raw::parseIni(text));
    raw::parseCm1Namelist(text);
    return 0;
}
