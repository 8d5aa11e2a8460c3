// The generator's raw stream: what `teapath random --bytes` writes. Not how the renderer takes its
// numbers (kernel/sampler.h), though the words are the same.
#pragma once

#include <teapath/core/tea.h>

#include <cstdint>
#include <span>

namespace tp {

/// Block i becomes the words of counter `first` + i (low half, high half) after `rounds` rounds.
void fill_random_stream(std::span<TeaBlock> blocks, uint64_t first, const TeaKey& key, int rounds);

}  // namespace tp
