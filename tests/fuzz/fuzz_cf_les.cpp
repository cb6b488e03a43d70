// fuzz_cf_les.cpp: any classic NetCDF file of an LES model is read or gives an Error.
//
// NetCDF-4 files are skipped, as in fuzz_wrf.cpp.
#include "core/base/error.h"
#include "tests/fuzz/read_everything.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const std::string_view content = fuzz::asText({bytes, count});
    if (!content.starts_with("CDF")) return 0;
    try {
        fuzz::readEverything(scratch.write("cm1out_000001.nc", content));
    } catch (const neph::Error&) {  // expected for invalid input
    }
    return 0;
}
