// checks_sky_test.cpp: the sky passes the checks that need no graphics.
#include <doctest/doctest.h>

#include "app/validate/checks.h"

using namespace neph::validate;

TEST_CASE("The clear sky is what is published and computed of clear skies") {
    for (const auto& rows : skyRows()) {
        for (const Row& row : rows) {
            CAPTURE(row.trial);
            CAPTURE(row.quantity);
            CAPTURE(row.measured);
            CAPTURE(*row.expected);
            CHECK(verdict(row) == Verdict::pass);
        }
    }
}
