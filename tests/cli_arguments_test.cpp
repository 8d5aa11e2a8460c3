#include "cli/arguments.h"

#include <teapath/core/error.h>

#include <doctest/doctest.h>

#include <limits>

namespace {

// The message of the usage error that `call` throws, or "" for none.
template <class Call>
std::string usage_error(const Call& call) {
    try {
        call();
    } catch (const tp::Error& error) {
        CHECK(error.kind() == tp::ErrorKind::Usage);
        CHECK_FALSE(error.remedy().empty());
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("whole numbers are taken whole and in range") {
    CHECK(tp::parse_whole("--spp", "64", 1, 100) == 64);
    CHECK(tp::parse_whole("--spp", "1", 1, 100) == 1);
    CHECK(tp::parse_whole("--spp", "100", 1, 100) == 100);
    for (const char* text : {"", "0", "101", "-1", "abc", "6.4", "64x", " 64", "64 ", "+64", "1e2",
                             "0x10", "99999999999999999999999", "-99999999999999999999999", "NaN"})
        CHECK_FALSE(usage_error([&] { tp::parse_whole("--spp", text, 1, 100); }).empty());
    CHECK(usage_error([] { tp::parse_whole("--spp", "abc", 1, 100); }) ==
          "--spp: 'abc' is not a whole number (give a whole number from 1 to 100)");
    CHECK(usage_error([] { tp::parse_whole("--spp", "99999999999999999999", 1, 100); }) ==
          "--spp: 99999999999999999999 is out of range (give a whole number from 1 to 100)");
}

TEST_CASE("seconds are above 0 and finite") {
    CHECK(tp::parse_seconds("--time", "90") == 90);
    CHECK(tp::parse_seconds("--time", "2.5") == 2.5);
    CHECK(tp::parse_seconds("--time", "1e-3") == 1e-3);
    for (const char* text : {"", "0", "-1", "nan", "inf", "1e400", "1e10", "ten", "5s", "0x10"})
        CHECK_FALSE(usage_error([&] { tp::parse_seconds("--time", text); }).empty());
}

TEST_CASE("a size is two whole numbers with an x") {
    const tp::ImageSize size = tp::parse_size("--size", "1920x1080");
    CHECK(size.width == 1920);
    CHECK(size.height == 1080);
    CHECK(tp::parse_size("--size", "1X1").width == 1);
    for (const char* text : {"", "x", "1920", "1920x", "x1080", "-5x5", "5x-5", "0x5", "5x0",
                             "1.5x2", "5x5x5", "5 x 5", "99999999999x5", "axb"})
        CHECK_FALSE(usage_error([&] { tp::parse_size("--size", text); }).empty());
}

TEST_CASE("a seed is any 64-bit number, or random") {
    CHECK(tp::parse_seed("--seed", "0") == 0);
    CHECK(tp::parse_seed("--seed", "18446744073709551615") == std::numeric_limits<uint64_t>::max());
    for (const char* text : {"", "-1", "18446744073709551616", "abc", "Random", "1.0"})
        CHECK_FALSE(usage_error([&] { tp::parse_seed("--seed", text); }).empty());
    CHECK(tp::parse_seed("--seed", "random") != tp::parse_seed("--seed", "random"));
}

TEST_CASE("backends go by name") {
    CHECK(tp::parse_backend("--backend", "auto") == tp::BackendKind::Auto);
    CHECK(tp::parse_backend("--backend", "cuda") == tp::BackendKind::Cuda);
    CHECK(tp::parse_backend("--backend", "host") == tp::BackendKind::Host);
    CHECK(usage_error([] { tp::parse_backend("--backend", "opencl"); }) ==
          "--backend: there is no backend 'opencl' (give one of auto, cuda, host)");
}
