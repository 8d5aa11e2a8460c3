// Figures as people read them.
#include "app/figures.h"

#include <doctest/doctest.h>

#include <vector>

using namespace tp;

TEST_CASE("figures: sizes, rates and times") {
    CHECK(memory_text(0) == "0 B");
    CHECK(memory_text(1536) == "1.5 KiB");
    CHECK(memory_text(size_t{25} << 20) == "25.0 MiB");
    CHECK(memory_text(size_t{150} << 30) == "150 GiB");
    CHECK(count_text(0) == "0 ");
    CHECK(count_text(1.94e9) == "1.9 G");
    CHECK(count_text(350'000) == "350 k");
    CHECK(count_text(999'999) == "1.0 M");
    CHECK(clock_time(42) == "0:42");
    CHECK(clock_time(3725) == "1:02:05");
    CHECK(clock_time(-1) == "0:00");
    CHECK(clock_time(1e300) == "days");
}

TEST_CASE("figures: quantiles") {
    std::vector<float> values;
    CHECK(quantile(values, 0.5) == 0);
    for (int i = 100; i >= 1; --i)
        values.push_back(static_cast<float>(i));
    CHECK(quantile(values, 0.5) == 50);
    CHECK(quantile(values, 0.99) == 99);
    CHECK(quantile(values, 1) == 100);
    CHECK(quantile(values, 0) == 1);
}

TEST_CASE("figures: the process holds some memory") {
    CHECK(process_memory() > 1 << 20);
}
