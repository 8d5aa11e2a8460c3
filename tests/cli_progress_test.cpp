#include "cli/progress_line.h"

#include <doctest/doctest.h>

namespace {

// Columns that UTF-8 text takes, where each character takes one.
size_t columns(const std::string& text) {
    size_t count = 0;
    for (const char c : text)
        if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) ++count;
    return count;
}

tp::ProgressFacts half_way() {
    return {32, 64, 0.5, 4.213e6, 61.2, false};
}

}  // namespace

TEST_CASE("durations read like a clock") {
    CHECK(tp::duration_text(0) == "0:00");
    CHECK(tp::duration_text(-3) == "0:00");
    CHECK(tp::duration_text(59.9) == "0:59");
    CHECK(tp::duration_text(725) == "12:05");
    CHECK(tp::duration_text(3723) == "1:02:03");
    CHECK(tp::duration_text(1e7) == "116 days");
    CHECK(tp::duration_text(1e300).ends_with(" days"));
}

TEST_CASE("rates have three digits") {
    CHECK(tp::rate_text(4.213e6) == "4.21 Msamples/s");
    CHECK(tp::rate_text(42.13e6) == "42.1 Msamples/s");
    CHECK(tp::rate_text(7545e6) == "7545 Msamples/s");
    CHECK(tp::rate_text(421.3e3) == "421 ksamples/s");
    CHECK(tp::rate_text(0) == "0.00 ksamples/s");
}

TEST_CASE("a bar never fills its last column, whatever the width") {
    for (int width = 1; width < 300; ++width) {
        for (const bool unicode : {false, true}) {
            const std::string text = tp::progress_bar(half_way(), width, unicode);
            CHECK(columns(text) <= static_cast<size_t>(std::max(1, width - 1)));
        }
    }
}

TEST_CASE("a bar shows samples, rate and time left where there is room") {
    CHECK(tp::progress_bar(half_way(), 80, false) ==
          "[################................]  50 %  32/64 spp  4.21 Msamples/s  1:02 left");
    CHECK(tp::progress_bar(half_way(), 40, false) == "[####.....]  50 %  32/64 spp  1:02 left");
    CHECK(tp::progress_bar(half_way(), 30, false) == " 50 %  32/64 spp  1:02 left");
    CHECK(tp::progress_bar(half_way(), 20, false) == " 50 %  32/64 spp");
    CHECK(tp::progress_bar(half_way(), 8, false) == " 50 %");
}

TEST_CASE("before the first sample a bar promises nothing") {
    const tp::ProgressFacts start{0, 64, 0, 0, -1, false};
    CHECK(tp::progress_text(start) == "  0 %  0/64 spp");
    const tp::ProgressFacts open_ended{0, 0, 0, 0, -1, false};
    CHECK(tp::progress_text(open_ended) == "  0 %  0 spp");
}

TEST_CASE("an interrupted render says that it is stopping") {
    tp::ProgressFacts facts = half_way();
    facts.stopping = true;
    CHECK(tp::progress_text(facts).ends_with("stopping after this step"));
}

TEST_CASE("a share out of range draws a whole or an empty bar") {
    tp::ProgressFacts facts = half_way();
    for (const double share : {-1.0, 2.0, 1e300}) {
        facts.share = share;
        const std::string text = tp::progress_bar(facts, 80, false);
        CHECK(text.find(share < 0 ? '#' : '.') > text.find(']'));
    }
}

TEST_CASE("the rate forgets the first step, which warms up, and what is long ago") {
    tp::RateMeter meter;
    CHECK(meter.rate() == 0);
    meter.add(0, 0);
    CHECK(meter.rate() == 0);
    meter.add(5, 1);  // the first sample took five seconds
    CHECK(meter.rate() == doctest::Approx(0.2));
    meter.add(6, 11);  // from now on ten a second
    CHECK(meter.rate() == doctest::Approx(10));
    for (int second = 7; second <= 100; ++second)
        meter.add(second, 11 + (second - 6) * 10);
    CHECK(meter.rate() == doctest::Approx(10));
    const int64_t done = 11 + 94 * 10;
    for (int second = 101; second <= 120; ++second)
        meter.add(second, done + (second - 100) * 2);  // the machine got other work
    CHECK(meter.rate() == doctest::Approx(2));
}
