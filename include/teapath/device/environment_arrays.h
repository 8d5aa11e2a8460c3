// The tables that kernel/environment.h samples an image by. Made once for each image that somebody
// holds.
#pragma once

#include <teapath/kernel/records.h>
#include <teapath/scene/image.h>

#include <memory>
#include <vector>

namespace tp {

struct EnvironmentArrays {
    uint32_t width = 0, height = 0;      // of the grid; at most 2048 x 1024
    std::vector<EnvironmentCell> rows;   // probability: of the row
    std::vector<EnvironmentCell> cells;  // row by row; probability: within its row

    size_t bytes() const { return (rows.size() + cells.size()) * sizeof(EnvironmentCell); }
    EnvironmentView view() const;
};

/// By luminance and solid angle, a little of it spread to cells beside bright ones, which texels
/// between reach into. On all cores.
std::shared_ptr<const EnvironmentArrays> environment_of(const std::shared_ptr<const Image>& image,
                                                        bool is_srgb);

}  // namespace tp
