// Inspector of generators.
#include "inspector.h"

#include <icons_font_awesome_6.h>

namespace tp {
namespace {

PropertyRows<Generator> property_rows(PanelContext& c, const std::vector<SceneItem>& items) {
    std::vector<const Generator*> things;
    std::vector<GeneratorId> ids;
    for (const SceneItem item : items)
        for (const Generator& g : c.document.scene().generators)
            if (g.id.value == item.id) {
                things.push_back(&g);
                ids.push_back(g.id);
            }
    const std::string what = ids.size() == 1 ? item_name(c.document.scene(), item_of(ids[0]))
                                             : fmt::format("{} generators", ids.size());
    return PropertyRows<Generator>(c, what, fmt::format("generator {}", ids.back().value),
                                   std::move(things),
                                   [ids](Scene& s, size_t i) { return find_generator(s, ids[i]); });
}

void size_rows(PropertyRows<Generator>& rows) {
    const auto count = [&](const char* name, const char* help, auto get) {
        rows.number(
            {.name = name, .help = help, .speed = 0.1, .low = 0, .high = 65535, .relative = true},
            get);
    };
    count(
        "Columns", "Spheres along x", [](auto& g) -> auto& { return g.grid.columns; });
    count(
        "Rows", "Spheres along z", [](auto& g) -> auto& { return g.grid.rows; });
    rows.number(
        {.name = "Spacing", .help = "Scene units between cells", .speed = 0.005, .relative = true},
        [](auto& g) -> auto& { return g.grid.spacing; });
    rows.number(
        {.name = "Centre", .help = "x and z of the grid's middle", .speed = 0.01},
        [](auto& g) -> auto& { return g.grid.center; });
    rows.number(
        {.name = "Ground", .help = "Height of the plane that they stand on", .speed = 0.01},
        [](auto& g) -> auto& { return g.grid.ground; });
    rows.number(
        {.name = "Radius",
         .help = "Of every sphere",
         .speed = 0.002,
         .low = 1e-6,
         .high = 1e6,
         .relative = true},
        [](auto& g) -> auto& { return g.grid.radius; });
    rows.number(
        {.name = "Jitter",
         .help = "How far a sphere may be from its cell's corner, in cells",
         .speed = 0.003},
        [](auto& g) -> auto& { return g.grid.jitter; });
}

void material_mix_rows(PropertyRows<Generator>& rows) {
    rows.number(
        {.name = "Matt",
         .help = "Share of Lambertian spheres",
         .speed = 0.003,
         .low = 0,
         .high = 1},
        [](auto& g) -> auto& { return g.grid.lambertian; });
    rows.number(
        {.name = "Metal",
         .help = "Share of metal spheres; what is left is glass",
         .speed = 0.003,
         .low = 0,
         .high = 1},
        [](auto& g) -> auto& { return g.grid.metal; });
    rows.number(
        {.name = "Glass index",
         .help = "Index of refraction of the glass spheres",
         .speed = 0.003,
         .low = 0.01,
         .high = 100},
        [](auto& g) -> auto& { return g.grid.ior; });
    rows.toggle(
        "Thesis colours", "Colours by the thesis' text instead of the book's rule",
        [](auto& g) -> auto& { return g.grid.thesis_colors; });
    rows.number(
        {.name = "Seed",
         .help = "Another number, other spheres",
         .speed = 0.1,
         .low = 0,
         .high = 9007199254740991.0},
        [](auto& g) -> auto& { return g.grid.seed; });
}

// Spheres of space that stay empty.
void clear_rows(PropertyRows<Generator>& rows) {
    size_t remove = rows.active().grid.keep_clear.size();
    for (size_t i = 0; i < rows.active().grid.keep_clear.size(); ++i) {
        const std::string name = fmt::format("Sphere {}", i + 1);
        Double4 sphere = rows.active().grid.keep_clear[i];
        const unsigned changed = ui::row({.name = name.c_str(),
                                          .help = "x, y, z and radius of a space that stays empty; "
                                                  "a radius of 0 removes it",
                                          .speed = 0.01},
                                         &sphere.x, nullptr, 4);
        if (changed == 0) continue;
        if (sphere.w <= 0) remove = i;
        rows.apply(name.c_str(), true, [&](Generator& g) {
            if (i < g.grid.keep_clear.size()) g.grid.keep_clear[i] = sphere;
        });
    }
    if (remove < rows.active().grid.keep_clear.size())
        rows.apply("Keep clear", false, [&](Generator& g) {
            if (remove < g.grid.keep_clear.size())
                g.grid.keep_clear.erase(g.grid.keep_clear.begin() +
                                        static_cast<std::ptrdiff_t>(remove));
        });
}

}  // namespace

void generator_inspector(PanelContext& c, const std::vector<SceneItem>& items) {
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<Generator> rows = property_rows(c, items);
    const SphereGrid& grid = rows.active().grid;
    inspector_header(
        c, items, ICON_FA_TABLE_CELLS,
        fmt::format("Generator, {} spheres at most", int64_t{grid.columns} * grid.rows));
    std::vector<std::string>& folded = c.ui.preferences.folded;
    if (ui::section("Grid", folded) && ui::begin_rows("grid")) {
        size_rows(rows);
        ui::end_rows();
    }
    if (ui::section("Materials##generator", folded) && ui::begin_rows("mix")) {
        material_mix_rows(rows);
        ui::end_rows();
    }
    if (ui::section("Keep clear", folded)) {
        if (ui::begin_rows("clear")) {
            clear_rows(rows);
            ui::end_rows();
        }
        if (ImGui::Button(ICON_FA_PLUS "  Sphere"))
            rows.apply("Keep clear", false, [](Generator& g) {
                g.grid.keep_clear.push_back({g.grid.center.x, g.grid.ground, g.grid.center.y, 1});
            });
        ui::tooltip("A space in which no sphere is made");
    }
    ImGui::Spacing();
    if (ImGui::Button("Make editable"))
        c.document.edit("Make editable", "", [](Scene& s) { realize_generators(s); });
    ui::tooltip("Turns all generators into objects that can be changed one by one");
}

}  // namespace tp
