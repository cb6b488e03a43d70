// fuzz_wrf.cpp: any classic NetCDF file is read or gives an Error.
//
// NetCDF-4 files are skipped: libhdf5 itself crashes and hangs on damaged files, which is why
// readers run in processes of their own; tests/readers/mutilation_test.cpp covers them there.
#include "core/base/error.h"
#include "tests/fuzz/read_everything.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const std::string_view content = fuzz::asText({bytes, count});
    if (!content.starts_with("CDF")) return 0;
    try {
        fuzz::readEverything(scratch.write("wrfout_0000", content));
    } catch (const neph::Error&) {  // expected for invalid input
    }
    return 0;
}
