// fuzz_map.cpp: any text is a map whose variables have a meaning, or an Error.
#include <cstdlib>

#include "core/plugin/reader_plugin.h"
#include "readers/cf_les/map_file.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    try {
        const cf::Model model = cf::parseMap(fuzz::asText({bytes, count}));
        if (model.names.empty()) std::abort();
        for (const cf::Name& name : model.names) {
            if (name.name.empty() || name.meaning == cf::Meaning::other) std::abort();
        }
    } catch (const neph::plugin::Error&) {  // expected for invalid input
    }
    return 0;
}
