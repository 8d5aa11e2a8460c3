// The sets of scene features that kernels are compiled for. The general one is always right; the
// others leave out code that a scene cannot reach.
#pragma once

#include <teapath/kernel/records.h>

namespace tp {

inline constexpr uint32_t kVariantSpheres = 0;  // constant colours, no lights but the background
inline constexpr uint32_t kVariantLit = kFeatureShapes | kFeatureLights;
inline constexpr uint32_t kVariantBooks =  // the shapes and materials of the books
    kFeatureAll &
    ~uint32_t{kFeatureMeshes | kFeaturePrincipled | kFeatureHiding | kFeatureProcedural};
inline constexpr uint32_t kVariantModels =  // all but what textures beyond images cost in registers
    kFeatureAll & ~uint32_t{kFeatureProcedural};
inline constexpr uint32_t kVariantGeneral = kFeatureAll;

/// Calls f.operator()<kFeatures>() for the smallest variant that has all `needed` features.
template <class F>
decltype(auto) with_variant(uint32_t needed, F&& f) {
    if ((needed & ~kVariantSpheres) == 0) return f.template operator()<kVariantSpheres>();
    if ((needed & ~kVariantLit) == 0) return f.template operator()<kVariantLit>();
    if ((needed & ~kVariantBooks) == 0) return f.template operator()<kVariantBooks>();
    if ((needed & ~kVariantModels) == 0) return f.template operator()<kVariantModels>();
    return f.template operator()<kVariantGeneral>();
}

}  // namespace tp
