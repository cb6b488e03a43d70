// fuzz_reader_texts.cpp: any text is a unit, a date or a CF time, or it is none.
#include <cstdlib>

#include "readers/shared/calendar.h"
#include "readers/shared/units.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = fuzz::asText({bytes, count});
    for (const char* wanted : {"kg kg-1", "Pa", "K", "m", "kg-1"}) {
        shared::conversion(text, wanted);
    }
    for (const shared::Calendar calendar :
         {shared::Calendar::gregorian, shared::Calendar::days360, shared::Calendar::noLeap}) {
        if (const auto seconds = shared::secondsOfDate(text, calendar)) {
            // A date that was read is written as one that reads the same, to the second.
            const std::string date = shared::dateOfSeconds(*seconds, calendar);
            if (*seconds < 3e11 && shared::secondsOfDate(date, calendar) != *seconds) std::abort();
        }
        shared::timeUnit(text, calendar);
    }
    return 0;
}
