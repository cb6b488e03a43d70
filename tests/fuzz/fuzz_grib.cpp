// fuzz_grib.cpp: any GRIB file is read or gives an Error.
//
// ecCodes, which itself crashes on damaged data, is replaced: what it unpacks it does in a process
// of its own, and tests/readers/mutilation_test.cpp covers it there.
#include "core/base/error.h"
#include "readers/grib/codes.h"
#include "tests/fuzz/read_everything.h"
#include "tests/fuzz/scratch.h"

namespace grib {

std::vector<float> unpackWithCodes(const Bytes&, unsigned) {
    throw Failure{"there is no ecCodes", {}, {}, {}};
}

ParameterText textWithCodes(const Bytes&) {
    return {};
}

}  // namespace grib

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    try {
        fuzz::readEverything(scratch.write("wrfnat.grib2", fuzz::asText({bytes, count})));
    } catch (const neph::Error&) {  // expected for invalid input
    }
    return 0;
}
