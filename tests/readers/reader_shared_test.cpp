// reader_shared_test.cpp: what the readers share: units, calendars, and files that are being
// written.
#include <doctest/doctest.h>

#include <fstream>

#include "readers/shared/calendar.h"
#include "readers/shared/units.h"
#include "readers/shared/writing.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using shared::Calendar;

TEST_CASE("Units convert as model output spells them") {
    struct Case {
        const char* from;
        const char* to;
        double one, ten;  // what 1 and 10 are
    };
    for (const Case& c : {Case{"g kg-1", "kg kg-1", 1e-3, 1e-2},
                          Case{"g/kg", "kg kg-1", 1e-3, 1e-2},
                          Case{"kg/kg", "kg kg-1", 1.0, 10.0},
                          Case{"1", "kg kg-1", 1.0, 10.0},
                          Case{"-", "kg kg-1", 1.0, 10.0},
                          Case{"hPa", "Pa", 1e2, 1e3},
                          Case{"mb", "Pa", 1e2, 1e3},
                          Case{"kPa", "Pa", 1e3, 1e4},
                          Case{"HPA", "Pa", 1e2, 1e3},
                          Case{"gpm", "m", 1.0, 10.0},
                          Case{"Kg/Kg", "kg kg-1", 1.0, 10.0},
                          Case{"[g/kg]", "kg kg-1", 1e-3, 1e-2},
                          Case{"kg kg-1 (dry air)", "kg kg-1", 1.0, 10.0},
                          Case{"kg kg{-1}", "kg kg-1", 1.0, 10.0},
                          Case{"degC", "K", 274.15, 283.15},
                          Case{"C", "K", 274.15, 283.15},
                          Case{"  kg(-1)", "kg-1", 1.0, 10.0},
                          Case{"# kg(-1)", "kg-1", 1.0, 10.0},
                          Case{"#/kg", "kg-1", 1.0, 10.0},
                          Case{"micron", "m", 1e-6, 1e-5},
                          Case{"um", "m", 1e-6, 1e-5},
                          Case{"kg m**-3", "kg m-3", 1.0, 10.0},
                          Case{"g/cm^3", "kg m-3", 1e3, 1e4},
                          Case{"km", "m", 1e3, 1e4}}) {
        CAPTURE(c.from);
        const auto conversion = shared::conversion(c.from, c.to);
        REQUIRE(conversion.has_value());
        CHECK((*conversion)(1.0) == doctest::Approx(c.one));
        CHECK((*conversion)(10.0) == doctest::Approx(c.ten));
    }
}

TEST_CASE("Units of another kind, and texts that are none, do not convert") {
    for (const char* from :
         {"m", "g m-3", "", "furlongs per fortnight squared", "kg kg", "@@@", "lg(re 1 mW)",
          "a text that is far longer than the name of any unit, "
          "as descriptions are that stand in their place"}) {
        CAPTURE(from);
        CHECK(!shared::conversion(from, "kg kg-1").has_value());
    }
    CHECK(!shared::conversion("mb", "kg").has_value());
}

TEST_CASE("Dates become seconds in every calendar, and back") {
    // 2000-03-01 in days since 0001-01-01.
    const auto days = [](Calendar calendar) {
        return *shared::secondsOfDate("2000-03-01", calendar) / 86400.0;
    };
    CHECK(days(Calendar::gregorian) == 730179.0);  // RFC 3339 dates: 1970-01-01 is 719162
    CHECK(days(Calendar::noLeap) == 1999 * 365 + 59);
    CHECK(days(Calendar::allLeap) == 1999 * 366 + 60);
    CHECK(days(Calendar::days360) == 1999 * 360 + 60);
    CHECK(days(Calendar::julian) == 1999 * 365 + 499 + 60);
    for (const Calendar calendar : {Calendar::gregorian, Calendar::julian, Calendar::noLeap,
                                    Calendar::allLeap, Calendar::days360}) {
        for (const char* date :
             {"0001-01-01_00:00:00", "1999-12-30_23:59:59", "2000-02-28_12:00:00",
              "2000-03-01_00:00:00", "2021-08-14_18:00:00"}) {
            CHECK(shared::dateOfSeconds(*shared::secondsOfDate(date, calendar), calendar) == date);
        }
    }
}

TEST_CASE("A date is read with or without an hour, and refused where it is none") {
    const double noon = *shared::secondsOfDate("2021-08-14 12:00:00");
    for (const char* text :
         {"2021-08-14T12:00:00Z", "2021-8-14 12", "2021-08-14_12:00", " 2021-08-14 12:00:00.0 "}) {
        CAPTURE(text);
        REQUIRE(shared::secondsOfDate(text).has_value());
        CHECK(*shared::secondsOfDate(text) == noon);
    }
    for (const char* text : {"", "2021", "2021-13-01", "2021-02-29", "2021-08-14x12:00:00",
                             "2021-08-14 12:61:00", "0000-01-01", "2021-08-14 12:00:00 or so"}) {
        CAPTURE(text);
        CHECK(!shared::secondsOfDate(text).has_value());
    }
    CHECK(shared::secondsOfDate("2021-02-30", Calendar::days360).has_value());
}

TEST_CASE("CF times count from their origin in their unit") {
    const auto hours = shared::timeUnit("hours since 2021-08-14 06:00:00", Calendar::gregorian);
    REQUIRE(hours.has_value());
    CHECK(hours->secondsOf(12.0) == *shared::secondsOfDate("2021-08-14 18:00:00"));
    CHECK(!shared::timeUnit("hours", Calendar::gregorian).has_value());
    CHECK(!shared::timeUnit("metres since 2021-08-14", Calendar::gregorian).has_value());
    CHECK(shared::calendarNamed("365_day") == Calendar::noLeap);
    CHECK(shared::calendarNamed(" Proleptic_Gregorian ") == Calendar::gregorian);
    CHECK(!shared::calendarNamed("mayan").has_value());
}

TEST_CASE("A file seems to be written for two minutes after it changed") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "x";
    CHECK(shared::beingWritten((folder / "a").string()).has_value());
    age(folder / "a");
    CHECK(!shared::beingWritten((folder / "a").string()).has_value());
    CHECK(!shared::beingWritten((folder / "none").string()).has_value());
}
