#include "gizmo_drag.h"

#include "transform_edit.h"

#include <cmath>

namespace tp {
namespace {

// Where the axes of a matrix are unit vectors but for rounding, the nearest rotation.
DoubleMat3 rotation_part(const DoubleMat4& m) {
    const Double3 x = glm::normalize(Double3(m[0]));
    const Double3 z = glm::normalize(glm::cross(x, Double3(m[1])));
    return DoubleMat3(x, glm::cross(z, x), z);
}

}  // namespace

void GizmoDrag::begin(const std::vector<const Object*>& objects, const Double3& place,
                      const DoubleMat3& axes) {
    is_active = true;
    is_uniform = false;
    starts.clear();
    for (const Object* o : objects)
        starts.push_back({o->id, o->transform});
    start = DoubleMat4(axes);
    start[3] = Double4(place, 1);
    now = start;
}

std::vector<GizmoDrag::Start> GizmoDrag::placed(GizmoKind kind) const {
    const Double3 pivot(start[3]);
    std::vector<Start> result = starts;
    for (Start& s : result) {
        switch (kind) {
            case GizmoKind::Move: s.transform = moved(s.transform, Double3(now[3]) - pivot); break;
            case GizmoKind::Rotate: {
                const DoubleMat3 turn = rotation_part(now) * glm::transpose(rotation_part(start));
                s.transform = turned_about(s.transform, pivot, turn);
                break;
            }
            case GizmoKind::Scale: {
                Double3 factor;
                for (int i = 0; i < 3; ++i)
                    factor[i] = glm::length(Double3(now[i])) / glm::length(Double3(start[i]));
                if (is_uniform) factor = Double3(factor.x);
                s.transform = scaled_about(s.transform, pivot, DoubleMat3(start), factor);
                break;
            }
        }
    }
    return result;
}

DoubleMat3 gizmo_axes(const Object& active, bool local) {
    return local ? rotation_of(active.transform) : DoubleMat3(1);
}

}  // namespace tp
