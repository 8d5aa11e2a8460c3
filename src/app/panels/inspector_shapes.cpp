// Rows of the shapes of objects.
#include "../dialogs/dialogs.h"
#include "inspector.h"

#include <teapath/scene/procedural_mesh.h>

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <string>
#include <string_view>
#include <vector>

namespace tp {
namespace {

// The member of a shape of a kind, in any object of that kind.
template <class Shape, class Member>
auto member(Member Shape::*m) {
    return [m](auto& o) -> auto& {
        return std::get<Shape>(o.shape).*m;
    };
}

ui::NumberRow point(const char* name, const char* help) {
    return {.name = name, .help = help, .speed = 0.01, .is_axis = true};
}

ui::NumberRow length(const char* name, const char* help, double low = 0) {
    return {.name = name, .help = help, .speed = 0.005, .low = low, .high = 1e9, .relative = true};
}

template <class Rect>
void axis_rect_rows(PropertyRows<Object>& rows, const char* low, const char* high, const char* k) {
    rows.number({.name = "Low corner", .help = low, .speed = 0.01}, member(&Rect::low));
    rows.number({.name = "High corner", .help = high, .speed = 0.01}, member(&Rect::high));
    rows.number({.name = "Offset", .help = k, .speed = 0.01}, member(&Rect::k));
    // What people think in: edits of the size keep the middle.
    const Rect& r = std::get<Rect>(rows.active().shape);
    Double2 size = r.high - r.low;
    const double standard[] = {1, 1};
    const ui::NumberRow row{.name = "Size",
                            .help = "Width and height about the middle",
                            .speed = 0.01,
                            .low = 1e-6,
                            .high = 1e9,
                            .relative = true};
    const unsigned changed = ui::row(row, &size.x, standard, 2);
    if (changed == 0) return;
    rows.apply("Size", true, [&](Object& o) {
        Rect& target = std::get<Rect>(o.shape);
        for (int i = 0; i < 2; ++i) {
            if ((changed >> i & 1) == 0) continue;
            const double middle = (target.low[i] + target.high[i]) / 2;
            target.low[i] = middle - size[i] / 2;
            target.high[i] = middle + size[i] / 2;
        }
    });
}

// What a mesh is made of, to be typed; all that are selected get it.
void recipe_row(PropertyRows<Object>& rows, const std::string& path) {
    constexpr std::string_view kScheme = "procedural://";  // which nobody needs to read
    ui::begin_row("Recipe", "What the program makes the mesh of; Enter makes it anew");
    ImGui::SetNextItemWidth(-1);
    std::string text = path.substr(kScheme.size());
    const bool is_entered =
        ImGui::InputText("##recipe", &text, ImGuiInputTextFlags_EnterReturnsTrue);
    ui::tooltip(text.c_str());
    if (!is_procedural(text)) text = std::string(kScheme) + text;
    if (!is_entered || text == path) return;
    std::vector<ObjectId> ids;
    for (const Object* object : rows.things())
        ids.push_back(object->id);
    change_mesh(rows.context(), ids, text);
}

struct ShapeRows {
    PropertyRows<Object>& rows;

    void operator()(const SphereShape&) const {
        rows.number(point("Centre", "In the object's own space"), member(&SphereShape::center));
        rows.number(
            length("Radius", "Negative turns the normal inwards, as for a bubble in glass", -1e9),
            member(&SphereShape::radius));
    }
    void operator()(const XyRectShape&) const {
        axis_rect_rows<XyRectShape>(rows, "Smallest x and y", "Largest x and y", "Its z");
    }
    void operator()(const XzRectShape&) const {
        axis_rect_rows<XzRectShape>(rows, "Smallest x and z", "Largest x and z", "Its y");
    }
    void operator()(const YzRectShape&) const {
        axis_rect_rows<YzRectShape>(rows, "Smallest y and z", "Largest y and z", "Its x");
    }
    void operator()(const RectangleShape&) const {
        rows.number(point("Corner", "Where texture coordinates are 0"),
                    member(&RectangleShape::corner));
        rows.number(point("Edge u", "From the corner along u"), member(&RectangleShape::edge_u));
        rows.number(point("Edge v", "From the corner along v"), member(&RectangleShape::edge_v));
    }
    void operator()(const BoxShape&) const {
        rows.number(point("Low corner", "Smallest x, y and z"), member(&BoxShape::low));
        rows.number(point("High corner", "Largest x, y and z"), member(&BoxShape::high));
    }
    void operator()(const DiskShape&) const {
        rows.number(point("Centre", "In the object's own space"), member(&DiskShape::center));
        rows.number(point("Normal", "Direction of the front"), member(&DiskShape::normal));
        rows.number(length("Radius", "In the object's own space"), member(&DiskShape::radius));
    }
    void operator()(const TriangleShape&) const {
        rows.number(point("A", "First corner"), member(&TriangleShape::a));
        rows.number(point("B", "Second corner, counter-clockwise from the front"),
                    member(&TriangleShape::b));
        rows.number(point("C", "Third corner"), member(&TriangleShape::c));
    }
    void operator()(const MeshShape& m) const {
        if (is_procedural(m.file.path))
            recipe_row(rows, m.file.path);
        else
            ui::row_text("File", m.file.path, "Where the triangles come from");
        if (const Mesh* mesh = m.file.mesh.get())
            ui::row_text(
                "Triangles",
                fmt::format("{}, {} vertices", mesh->triangles.size(), mesh->positions.size()),
                "Of the mesh; copies of it share them");
        else
            ui::row_text("Triangles", "the file is missing", "Nothing of it can be shown");
        rows.toggle("Smooth", "Shade by the mesh's normals, where it has any",
                    member(&MeshShape::smooth));
    }
};

}  // namespace

void shape_rows(PropertyRows<Object>& rows) {
    std::visit(ShapeRows{rows}, rows.active().shape);
}

}  // namespace tp
