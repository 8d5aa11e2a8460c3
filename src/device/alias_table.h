// Alias tables (Walker 1977) by Vose's construction (1991): every column is filled up by one other.
#pragma once

#include <teapath/core/math.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

/// Sets `alias_threshold` and `alias` of `count` cells from their probabilities, which add up to 1.
template <class Cell>
void fill_alias_table(Cell* cells, const std::vector<double>& probability) {
    const size_t n = probability.size();
    std::vector<double> level(n);
    std::vector<uint32_t> low, high;
    for (size_t i = 0; i < n; ++i) {
        level[i] = probability[i] * static_cast<double>(n);
        (level[i] < 1 ? low : high).push_back(static_cast<uint32_t>(i));
    }
    while (!low.empty() && !high.empty()) {
        const uint32_t small = low.back(), large = high.back();
        low.pop_back();
        cells[small].alias_threshold = static_cast<Real>(level[small]);
        cells[small].alias = large;
        level[large] -= 1 - level[small];
        if (level[large] < 1) {
            high.pop_back();
            low.push_back(large);
        }
    }
    for (const auto* rest : {&low, &high}) {
        for (const uint32_t i : *rest) {
            cells[i].alias_threshold = 1;
            cells[i].alias = i;
        }
    }
}

}  // namespace tp
