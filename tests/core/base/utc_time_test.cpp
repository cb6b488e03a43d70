// utc_time_test.cpp: dates against published Julian days, and texts of dates.
#include "core/base/utc_time.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

UtcTime parsed(const char* text) {
    const auto time = utcOfText(text);
    REQUIRE(time);
    return *time;
}

}  // namespace

TEST_CASE("Dates are counted as Julian days are") {
    // [Meeus98] ch. 7, p. 62.
    struct Row {
        const char* utc;
        double julianDay;
    };
    for (const Row& row :
         {Row{"2000-01-01T12:00:00Z", 2451545.0}, Row{"1999-01-01T00:00:00Z", 2451179.5},
          Row{"1987-06-19T12:00:00Z", 2446966.0}, Row{"1988-01-27T00:00:00Z", 2447187.5},
          Row{"1988-06-19T12:00:00Z", 2447332.0}, Row{"1900-01-01T00:00:00Z", 2415020.5},
          Row{"1600-12-31T00:00:00Z", 2305812.5}}) {
        CAPTURE(row.utc);
        CHECK(parsed(row.utc).time_since_epoch().count() / 86400.0 + 2440587.5 == row.julianDay);
        CHECK(utcText(parsed(row.utc)) == row.utc);
    }
    CHECK(utcText(parsed("2021-08-14T18:00:00.25")) == "2021-08-14T18:00:00.3Z");
    CHECK(utcText(parsed("2021-08-14 18:00")) == "2021-08-14T18:00:00Z");
}

TEST_CASE("A text that is no time in UTC is none") {
    for (const char* text :
         {"", "2021-08-14", "2021-02-29T00:00:00Z", "2021-13-01T00:00:00Z", "2021-08-14T24:00:00Z",
          "2021-08-14T18:60:00Z", "2021-08-14T18:00:00+02:00", "2021-08-14T18", "21-8-14T18:00",
          "2021-08-14T18:00:00Z.", "-021-08-14T18:00:00Z"}) {
        CAPTURE(text);
        CHECK_FALSE(utcOfText(text));
    }
}

TEST_CASE("A time is a day of the year and an hour, also in leap years") {
    const YearTime last = yearTimeOf(parsed("2020-12-31T18:30:00Z"));
    CHECK(last.year == 2020);
    CHECK(last.day == 366);
    CHECK(last.hour == doctest::Approx(18.5));
    CHECK(yearTimeOf(parsed("2020-02-29T00:00:00Z")).day == 60);
    CHECK(yearTimeOf(parsed("2021-03-01T00:00:00Z")).day == 60);
    CHECK(yearTimeOf(parsed("1969-12-31T23:00:00Z")).day == 365);
    CHECK(utcText(utcOf({2021, 226, 18.0})) == "2021-08-14T18:00:00Z");
}
