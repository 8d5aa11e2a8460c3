// A drag of the gizmo: what it began with, so that the objects are placed from there in each frame
// and nothing drifts. Pure: the gizmo's matrix goes in, transforms come out.
#pragma once

#include <teapath/scene/object.h>

#include <vector>

namespace tp {

enum class GizmoKind { Move, Rotate, Scale };

struct GizmoDrag {
    struct Start {
        ObjectId id;
        Transform transform;
    };

    bool is_active = false;
    std::vector<Start> starts;
    DoubleMat4 start{1};      // the gizmo's matrix at the beginning: axes of unit length, place
    DoubleMat4 now{1};        // the same after the drag so far
    bool is_uniform = false;  // scaling by the middle

    /// Begins with these objects and a gizmo at `place` whose axes are the columns of `axes`.
    void begin(const std::vector<const Object*>& objects, const Double3& place,
               const DoubleMat3& axes);
    /// Where each object is placed by the drag so far.
    std::vector<Start> placed(GizmoKind kind) const;
};

/// The axes of the gizmo: the world's, or those of the active object.
DoubleMat3 gizmo_axes(const Object& active, bool local);

}  // namespace tp
