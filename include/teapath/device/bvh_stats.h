// What is known of a tree once it is built.
#pragma once

namespace tp {

struct BvhStats {
    double sah_cost = 0;  // expected steps of a random ray through the root box
    int depth = 0;        // levels of nodes; the traversal stack never holds more entries
    int leaf_count = 0;
    double build_seconds = 0;
};

}  // namespace tp
