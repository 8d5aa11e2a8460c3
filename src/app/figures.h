// Figures of the render as people read them, and statistics of frames. No ImGui.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tp {

/// "1.9 GiB", "25.8 MiB".
std::string memory_text(size_t bytes);
/// "1.9 G", "350 k": a number with a unit's prefix and the space before it.
std::string count_text(double count);
/// "0:42", "1:02:05".
std::string clock_time(double seconds);

/// The value that a share of the values does not pass; 0 of none. `share` 0.5 is the median.
float quantile(std::span<const float> values, double share);

/// Bytes of memory that the process holds; 0 where the system does not tell.
size_t process_memory();

}  // namespace tp
