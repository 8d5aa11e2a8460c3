// Meshes: no ray slips between triangles, the two trees find what brute force finds, instances
// share one mesh, and an edit leaves meshes alone.
#include "support/meshes.h"
#include "support/scene_maker.h"

#include <teapath/device/pick.h>
#include <teapath/kernel/mesh/mesh_traverse.h>
#include <teapath/kernel/traverse.h>

#include <doctest/doctest.h>

using namespace tp;
using namespace tp::test;

namespace {

SceneArrays arrays_of_scene(const Scene& scene) {
    SceneArrays arrays;
    flatten(scene, SceneParts::All, arrays);
    return arrays;
}

// The arrays as a kernel sees them.
struct View {
    SceneArrays arrays;
    std::vector<MeshView> meshes;
    SceneView view;

    explicit View(const Scene& scene) : arrays(arrays_of_scene(scene)) {
        for (const MeshOfScene& mesh : arrays.meshes)
            meshes.push_back(mesh.arrays->view());
        view.hittables = make_span(std::as_const(arrays.hittables));
        view.nodes = make_span(std::as_const(arrays.nodes));
        view.instances = make_span(std::as_const(arrays.instances));
        view.meshes = make_span(std::as_const(meshes));
        view.bounds = arrays.bounds;
    }
    Hit shoot(const Double3& from, const Double3& to) const {
        return intersect_scene<kFeatureAll>(view, Vec3(from), Vec3(glm::normalize(to - from)),
                                            kInfinity);
    }
};

Double3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(Double3(normal(random), normal(random), normal(random)));
}

}  // namespace

TEST_CASE("meshes: a ray at a corner or an edge of a closed mesh always meets it") {
    const auto mesh = share(ball_mesh(4, 0.2));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share_of_edge(0, 1);
    struct Placing {
        Double3 translation, rotation, scale;
    };
    for (const Placing& placing :
         {Placing{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}}, Placing{{3, -7, 2}, {10, 20, 30}, {1, 1, 1}},
          Placing{{100, 50, 20}, {33, 0, 71}, {0.01, 2, -1}},
          Placing{{0, 0, 0}, {45, 45, 45}, {1000, 1000, 1000}}}) {
        SceneMaker maker;
        Object& object = maker.object(mesh_shape(mesh), maker.lambertian(0.5));
        object.transform = {placing.translation, placing.rotation, placing.scale};
        const View view(maker.scene);
        const DoubleMat4 world = world_from_object(object.transform);
        const Double3 inside = Double3(world[3]);
        const double size = glm::length(placing.scale);
        int64_t missed = 0, rays = 0;
        for (int round = 0; round < 4; ++round) {
            for (const auto& t : mesh->triangles) {
                const Double3 a = mesh->positions[t[0]], b = mesh->positions[t[1]];
                const double s = round == 0 ? 0 : round == 1 ? 0.5 : share_of_edge(random);
                const Double3 target = Double3(world * Double4(a * (1 - s) + b * s, 1));
                missed += view.shoot(inside, target).index == kNoHit;
                // From beyond, past the silhouette's edges too.
                const Double3 outside = inside + random_direction(random) * size * 4.0;
                missed += view.shoot(outside, inside * 0.01 + target * 0.99).index == kNoHit;
                rays += 2;
            }
        }
        CAPTURE(rays);
        CHECK(missed == 0);
    }
}

TEST_CASE("meshes: the two trees find what separate triangles find") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-5, 5), edge(-1, 1);
    Mesh mesh;
    SceneMaker apart, together;
    const MaterialId m = apart.lambertian(0.5);
    for (int i = 0; i < 3000; ++i) {
        const Double3 a(place(random), place(random), place(random));
        const Float3 corners[] = {Float3(a),
                                  Float3(a + Double3(edge(random), edge(random), edge(random))),
                                  Float3(a + Double3(edge(random), edge(random), edge(random)))};
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), std::begin(corners), std::end(corners));
        mesh.triangles.push_back({first, first + 1, first + 2});
        apart.object(TriangleShape{Double3(corners[0]), Double3(corners[1]), Double3(corners[2])},
                     m);
    }
    together.object(mesh_shape(mesh), together.lambertian(0.5));
    const View one(apart.scene), other(together.scene);
    int parted = 0, met = 0;
    for (int i = 0; i < 20000; ++i) {
        const Double3 from(place(random), place(random), place(random));
        const Double3 to = from + random_direction(random);
        const Hit a = one.shoot(from, to), b = other.shoot(from, to);
        met += a.index != kNoHit;
        const bool same = (a.index == kNoHit) == (b.index == kNoHit) &&
                          (a.index == kNoHit || abs(a.t - b.t) < Real(1e-4) * (1 + a.t));
        parted += !same;
        // Any hit is found where one is.
        Hit any;
        const Vec3 d = Vec3(glm::normalize(to - from));
        CHECK((traverse<kFeatureAll, true>(other.view, Vec3(from), d, {}, any)) ==
              (b.index != kNoHit));
    }
    CHECK(met > 5000);
    CHECK(parted <= 4);  // grazing an edge, decided by rounding
}

TEST_CASE("meshes: ten thousand instances share one mesh, and a move touches the top alone") {
    SceneMaker maker;
    const MaterialId m = maker.lambertian(0.5);
    const auto mesh = share(ball_mesh(3));
    for (int i = 0; i < 10000; ++i)
        maker.object(mesh_shape(mesh), m).transform.translation = {3.0 * (i % 100), 0,
                                                                   3.0 * (i / 100)};
    SceneArrays arrays = arrays_of_scene(maker.scene);
    REQUIRE(arrays.meshes.size() == 1);
    CHECK(arrays.instances.size() == 10000);
    CHECK((arrays.features & kFeatureMeshes) != 0);
    const MeshArrays* made = arrays.meshes[0].arrays.get();

    maker.scene.objects.edit()[77].transform.translation.y = 1;
    flatten(maker.scene, SceneParts::Geometry, arrays);
    REQUIRE(arrays.meshes.size() == 1);
    CHECK(arrays.meshes[0].arrays.get() == made);
    // Another render of the same mesh shares it too.
    CHECK(arrays_of_scene(maker.scene).meshes[0].arrays.get() == made);

    // What is deleted stays while an undo may bring it back, and goes with its last holder.
    maker.scene.objects.edit().clear();
    flatten(maker.scene, SceneParts::Geometry, arrays);
    CHECK(arrays.meshes.size() == 1);
    CHECK((arrays.features & kFeatureMeshes) == 0);
}

TEST_CASE("meshes: bytes of a triangle, its tree included, stay below a hundred") {
    SceneMaker maker;
    Mesh mesh = ball_mesh(6, 0.01);
    mesh.uvs = {std::vector<Float2>(mesh.positions.size())};
    maker.object(mesh_shape(mesh), maker.lambertian(0.5));
    const SceneArrays arrays = arrays_of_scene(maker.scene);
    const double each = static_cast<double>(arrays.meshes[0].arrays->bytes()) /
                        static_cast<double>(mesh.triangles.size());
    CAPTURE(each);
    if (sizeof(Real) == 4) CHECK(each < 100);
}

TEST_CASE("meshes: what has no size, no file or no finite place is not shown and does no harm") {
    SceneMaker maker;
    const MaterialId m = maker.lambertian(0.5);
    maker.object(MeshShape{}, m);
    maker.object(mesh_shape(Mesh{}), m);
    Mesh flat = square_mesh();
    for (Float3& p : flat.positions)
        p = {1, 1, 1};
    maker.object(mesh_shape(flat), m);
    maker.object(mesh_shape(square_mesh()), m).transform.translation = {1e300, 0, 0};
    const View view(maker.scene);
    CHECK(view.shoot({0, 0, 5}, {0, 0, 0}).index == kNoHit);
    CHECK(render(maker.scene, 1).radiance.size() == 3 * 64 * 48);
}
