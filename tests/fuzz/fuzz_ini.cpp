// fuzz_ini.cpp: any text is an .ini file, and a namelist.
#include "readers/les/cm1_run.h"
#include "readers/raw_les/ini.h"
#include "readers/raw_les/microhh_names.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = fuzz::asText({bytes, count});
    les::hydrometeorsOf(les::parseIni(text));
    les::parseCm1Namelist(text);
    return 0;
}
