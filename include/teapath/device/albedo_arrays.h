// The tables of kernel/bsdf/albedo_table.h, made by integrating the lobes themselves. Made once in
// a program, when a scene first needs them.
#pragma once

#include <teapath/kernel/bsdf/albedo_table.h>

#include <vector>

namespace tp {

struct AlbedoArrays {
    std::vector<Vec2> ggx, ggx_average;
    std::vector<Real> sheen, glass;

    AlbedoTables view() const {
        return {ggx.data(), ggx_average.data(), sheen.data(), glass.data()};
    }
};

/// The tables; takes some tens of milliseconds the first time, on all cores.
const AlbedoArrays& albedo_arrays();

}  // namespace tp
