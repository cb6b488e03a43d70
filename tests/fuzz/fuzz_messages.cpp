// fuzz_messages.cpp: anything that a reader process sends is a valid message or Malformed.
#include "core/plugin/reader_wire.h"
#include "tests/fuzz/scratch.h"

namespace {

template <typename Unpack>
void read(std::string_view bytes, Unpack&& unpack) {
    try {
        neph::wire::Unpacker from(bytes);
        unpack(from);
        from.end();
    } catch (const neph::wire::Malformed&) {  // expected for invalid input
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    if (count == 0) return 0;
    const std::string_view rest = fuzz::asText({bytes + 1, count - 1});
    switch (bytes[0] % 3) {
        case 0:
            read(rest, neph::wire::unpackInfo);
            break;
        case 1:
            read(rest, neph::wire::unpackIdentity);
            break;
        default:
            read(rest, neph::wire::unpackError);
    }
    return 0;
}
