// How many samples the next step takes: a pure function of measured times.
#pragma once

#include <cstdint>

namespace tp {

struct StepHistory {
    int64_t done = 0;           // samples per pixel so far
    int64_t target = 0;         // samples per pixel wanted
    int64_t last_samples = 0;   // of the step before; 0 = there was none
    double last_seconds = 0;    // that it took
    double budget_seconds = 0;  // that a step should take
};

/// Samples for the next step: at least 1 unless done >= target, then 0. The first step is one
/// sample, so that a picture is there soon; later ones grow at most fourfold towards the budget.
int64_t next_samples(const StepHistory& history);

}  // namespace tp
