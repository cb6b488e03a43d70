// The entry point that every test program shares.
#define DOCTEST_CONFIG_IMPLEMENT  // outright: precompiled, the header was seen before it could say
                                  // so
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
