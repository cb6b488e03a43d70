// fuzz_ctl.cpp: any text is a GrADS descriptor or an Error.
#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/grads_ctl.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = fuzz::asText({bytes, count});
    raw::looksLikeCtl(text);
    try {
        raw::parseCtl(text);
    } catch (const neph::plugin::Error&) {  // expected for invalid input
    }
    return 0;
}
