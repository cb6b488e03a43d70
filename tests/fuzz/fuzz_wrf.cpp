// fuzz_wrf.cpp: any classic NetCDF file is read, or an Error says why not.
//
// Files with HDF5 inside are left out: libhdf5 itself crashes and hangs on damaged ones, which is
// why readers run in processes of their own; tests/readers/mutilation_test.cpp covers them there.
#include "core/base/error.h"
#include "tests/fuzz/read_everything.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const std::string_view content = fuzz::asText({bytes, count});
    if (!content.starts_with("CDF")) return 0;
    try {
        fuzz::readEverything(scratch.write("wrfout", content));
    } catch (const neph::Error&) {  // the expected answer to nonsense
    }
    return 0;
}
