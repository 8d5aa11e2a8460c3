#include <teapath/render/scheduler.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

namespace {

struct Run {
    int64_t steps = 0;
    int64_t done = 0;
    double longest_seconds = 0;
    double seconds = 0;
};

// Follows the scheduler through a render whose steps take fixed + samples * per_sample seconds.
Run simulate(int64_t target, double budget, double fixed, double per_sample) {
    Run run;
    tp::StepHistory history{0, target, 0, 0, budget};
    while (const int64_t samples = tp::next_samples(history)) {
        REQUIRE(samples >= 1);
        const double seconds = fixed + per_sample * static_cast<double>(samples);
        history.done += samples;
        history.last_samples = samples;
        history.last_seconds = seconds;
        run.done = history.done;
        run.seconds += seconds;
        run.longest_seconds = std::max(run.longest_seconds, seconds);
        ++run.steps;
        REQUIRE(run.steps < 100000);
    }
    return run;
}

}  // namespace

TEST_CASE("the first step is one sample, and none follows the last") {
    CHECK(tp::next_samples({0, 100, 0, 0, 0.25}) == 1);
    CHECK(tp::next_samples({100, 100, 8, 0.1, 0.25}) == 0);
    CHECK(tp::next_samples({101, 100, 8, 0.1, 0.25}) == 0);
    CHECK(tp::next_samples({0, 0, 0, 0, 0.25}) == 0);
}

TEST_CASE("a render ends with exactly the samples that it was asked for") {
    for (const int64_t target : {1, 2, 3, 31, 32, 33, 1000, 4096})
        for (const double per_sample : {1e-6, 1e-3, 0.02, 3.0})
            CHECK(simulate(target, 0.25, 0, per_sample).done == target);
}

TEST_CASE("steps fill the budget and do not pass it by much") {
    const Run run = simulate(100000, 0.25, 0, 1e-3);
    CHECK(run.longest_seconds <= 0.25 * 1.01);
    CHECK(run.steps < 100000 / 250 + 10);
}

TEST_CASE("a sample that takes longer than the budget is a step of its own") {
    const Run run = simulate(10, 0.25, 0, 3.0);
    CHECK(run.steps == 10);
    CHECK(run.longest_seconds == doctest::Approx(3.0));
}

TEST_CASE("a step grows at most fourfold, however fast the one before seemed") {
    CHECK(tp::next_samples({1, 1000, 1, 1e-9, 0.25}) == 4);
    CHECK(tp::next_samples({5, 1000, 4, 0.0, 0.25}) == 16);
    CHECK(tp::next_samples({5, 7, 4, 0.0, 0.25}) == 2);
}

TEST_CASE("a slow step is followed by a short one") {
    CHECK(tp::next_samples({200, 1000, 100, 2.5, 0.25}) == 10);
    CHECK(tp::next_samples({200, 1000, 100, 1000.0, 0.25}) == 1);
    CHECK(tp::next_samples({200, 1000, 100, 2.5, 0.0}) == 1);
}

TEST_CASE("targets and steps near the largest number do not overflow") {
    constexpr int64_t kMost = std::numeric_limits<int64_t>::max();
    CHECK(tp::next_samples({0, kMost, 0, 0, 0.25}) == 1);
    CHECK(tp::next_samples({1, kMost, int64_t{1} << 40, 1e-9, 0.25}) == int64_t{1} << 42);
    CHECK(tp::next_samples({1, kMost, kMost / 2, 1e-9, 0.25}) >= 1);
}
