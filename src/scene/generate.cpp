// Generators into objects and materials.
#include <teapath/core/tea.h>
#include <teapath/scene/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// The random numbers of one cell of a grid: independent of the other cells.
class CellRandom {
public:
    CellRandom(const TeaKey& key, int column, int row)
        : key_(key), cell_(static_cast<uint32_t>(row) << 16 | static_cast<uint32_t>(column)) {}

    // The next number, in [0, 1).
    double next() { return (tea_encrypt({cell_, counter_++}, key_, 16).v0 >> 8) * 0x1p-24; }
    Double3 next_color() {
        const double r = next(), g = next(), b = next();
        return {r, g, b};
    }

private:
    TeaKey key_;
    uint32_t cell_;
    uint32_t counter_ = 0;
};

// Lambertian colours: product of two randoms, or the square of one by the thesis' text. Metal:
// half of 1 plus a random, or the mean of a random and 0.5. Fuzz is at most 0.5.
Material random_material(const SphereGrid& grid, CellRandom& random) {
    Material m;
    const double choice = random.next();
    if (choice < grid.lambertian) {
        const Double3 a = random.next_color();
        m.color.color = a * (grid.thesis_colors ? a : random.next_color());
    } else if (choice < grid.lambertian + grid.metal) {
        m.kind = MaterialKind::Metal;
        const Double3 a = random.next_color();
        m.color.color = grid.thesis_colors ? (a + 0.5) * 0.5 : (a + 1.0) * 0.5;
        m.fuzz = 0.5 * random.next();
    } else {
        m.kind = MaterialKind::Dielectric;
        m.color.color = {1, 1, 1};
        m.ior = grid.ior;
    }
    return m;
}

bool is_kept_clear(const SphereGrid& grid, const Double3& p) {
    return std::any_of(grid.keep_clear.begin(), grid.keep_clear.end(),
                       [&](const Double4& s) { return glm::distance(p, Double3(s)) <= s.w; });
}

// The corner of the grid's first cell: x, z.
Double2 first_corner(const SphereGrid& grid) {
    return grid.center - Double2(grid.columns, grid.rows) * (grid.spacing / 2);
}

void expand_grid(const Generator& generator, uint32_t& object_id, uint32_t& material_id,
                 Scene& scene) {
    const SphereGrid& grid = generator.grid;
    const TeaKey key = tea_key(0, grid.seed);
    const Double2 low = first_corner(grid);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            CellRandom random(key, column, row);
            const double dx = random.next(), dz = random.next();
            const Double3 center{low.x + (column + grid.jitter * dx) * grid.spacing,
                                 grid.ground + grid.radius,
                                 low.y + (row + grid.jitter * dz) * grid.spacing};
            if (is_kept_clear(grid, center)) continue;
            Material material = random_material(grid, random);
            material.id = {++material_id};
            scene.materials.edit().push_back(std::move(material));
            Object object;
            object.id = {++object_id};
            object.shape = SphereShape{center, grid.radius};
            object.material = {material_id};
            scene.objects.edit().push_back(std::move(object));
        }
    }
}

template <class List>
uint32_t largest_id(const List& things) {
    uint32_t largest = 0;
    for (const auto& thing : things)
        largest = std::max(largest, thing.id.value);
    return largest;
}

}  // namespace

GridBox box_of_centers(const SphereGrid& grid) {
    const Double2 first = first_corner(grid) + std::min(0.0, grid.jitter) * grid.spacing;
    const Double2 cells(grid.columns - 1, grid.rows - 1);
    const Double2 last = first + (cells + std::abs(grid.jitter)) * grid.spacing;
    const double y = grid.ground + grid.radius;
    const Double2 low = glm::min(first, last), high = glm::max(first, last);
    return {{low.x, y, low.y}, {high.x, y, high.y}};
}

Scene expand_generators(const Scene& scene) {
    Scene expanded = scene;
    expanded.generators = {};
    uint32_t object_id = largest_id(scene.objects), material_id = largest_id(scene.materials);
    for (const Generator& generator : scene.generators)
        expand_grid(generator, object_id, material_id, expanded);
    return expanded;
}

}  // namespace tp
