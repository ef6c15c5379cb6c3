// The tests' main(), which version 3 of Catch2 brings itself.
#ifndef TUMBLE_CATCH2_VERSION_3
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
