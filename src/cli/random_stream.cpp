#include "random_stream.h"

#include <algorithm>
#include <cstddef>

namespace tp {
namespace {

// Several counters go through the rounds side by side, which compilers make into vector code
// whatever the number of rounds.
constexpr size_t kLanes = 16;

void fill_lanes(TeaBlock* blocks, uint64_t first, const TeaKey& key, int rounds) {
    uint32_t v0[kLanes], v1[kLanes];
    for (size_t i = 0; i < kLanes; ++i) {
        v0[i] = static_cast<uint32_t>(first + i);
        v1[i] = static_cast<uint32_t>((first + i) >> 32);
    }
    uint32_t sum = 0;
    for (int round = 0; round < rounds; ++round) {
        sum += kTeaDelta;
        for (size_t i = 0; i < kLanes; ++i) {
            TeaBlock block{v0[i], v1[i]};
            tea_cycle(block, key, sum);
            v0[i] = block.v0;
            v1[i] = block.v1;
        }
    }
    for (size_t i = 0; i < kLanes; ++i)
        blocks[i] = {v0[i], v1[i]};
}

}  // namespace

void fill_random_stream(std::span<TeaBlock> blocks, uint64_t first, const TeaKey& key, int rounds) {
    size_t done = 0;
    for (; done + kLanes <= blocks.size(); done += kLanes)
        fill_lanes(&blocks[done], first + done, key, rounds);
    TeaBlock last[kLanes];
    fill_lanes(last, first + done, key, rounds);
    std::copy_n(last, blocks.size() - done, blocks.begin() + static_cast<std::ptrdiff_t>(done));
}

}  // namespace tp
