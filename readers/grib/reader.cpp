// reader.cpp: entry point of the GRIB reader.
#include <array>

#include "core/plugin/reader_plugin.h"
#include "readers/grib/grib_file.h"

namespace {

namespace plugin = neph::plugin;

/// GRIB of edition 1 scores a little: opening it then says how to convert it.
int score(const char* path) {
    constexpr int kOtherEdition = 5, kSecondEdition = 80;
    try {
        std::array<std::uint8_t, 1024> head{};
        const std::size_t there = grib::InputFile(path).read(0, head);
        const auto start = grib::messageStart(grib::ByteSpan(head).first(there));
        if (!start) return 0;
        return head[*start + 7] == 2 ? kSecondEdition : head[*start + 7] == 1 ? kOtherEdition : 0;
    } catch (const grib::Failure&) {
        return 0;
    }
}

constexpr plugin::Reader kReader{"grib",
                                 "1.0",
                                 "GRIB of edition 2 (HRRR, RRFS and others)",
                                 "grib2 grb2 grib grb",
                                 &score,
                                 &plugin::openAs<grib::GribFile>};

}  // namespace

NEPHOSCOPE_READER(kReader)
