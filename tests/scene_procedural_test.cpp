// Procedural meshes: they are sound, closed where they should be, the same each time, and wrong
// names and numbers are refused.
#include <teapath/core/error.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/procedural_mesh.h>

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

using namespace tp;

namespace {

std::string refusal(const std::string& path) {
    try {
        procedural_mesh(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// Volume by the divergence theorem: positive where fronts look outwards.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Double3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

// The largest gap along open edges: edges that only one triangle has, by place.
size_t open_edges(const Mesh& mesh) {
    using Place = std::array<long, 3>;
    const auto place = [&](uint32_t i) {
        const Float3 p = mesh.positions[i];
        return Place{std::lround(p.x * 1e4f), std::lround(p.y * 1e4f), std::lround(p.z * 1e4f)};
    };
    std::map<std::pair<Place, Place>, int> edges;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const Place a = place(t[static_cast<size_t>(k)]);
            const Place b = place(t[static_cast<size_t>((k + 1) % 3)]);
            if (a == b) continue;
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    size_t open = 0;
    for (const auto& [edge, count] : edges)
        open += count != 0;
    return open;
}

}  // namespace

TEST_CASE("procedural: every kind makes a sound mesh, the same each time") {
    for (const ProceduralKind& kind : procedural_kinds()) {
        CAPTURE(kind.name);
        const std::string name = std::string("procedural://") + kind.name;
        const Mesh mesh = procedural_mesh(name);
        CHECK(problem_of(mesh) == "");
        CHECK(mesh.triangles.size() > 10);
        CHECK(mesh == procedural_mesh(name));
        // The parameters that are told are its own.
        if (*kind.parameters) CHECK(mesh == procedural_mesh(name + "?" + kind.parameters));
        for (const Float3& n : mesh.normals)
            REQUIRE(glm::length(n) == doctest::Approx(1).epsilon(1e-3));
        // Normals are on the side of the fronts.
        if (mesh.normals.empty()) continue;
        size_t against = 0;
        for (const auto& t : mesh.triangles) {
            const Float3 front = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                            mesh.positions[t[2]] - mesh.positions[t[0]]);
            const Float3 n = mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]];
            against += glm::dot(front, n) < -1e-3f * glm::length(front);
        }
        CHECK(against <= mesh.triangles.size() / 200);
    }
}

TEST_CASE("procedural: solids are closed and look outwards") {
    for (const char* name :
         {"bottle", "wine_glass", "bowl", "knot", "torus", "rounded_box", "gem"}) {
        CAPTURE(name);
        const Mesh mesh = procedural_mesh(std::string("procedural://") + name);
        CHECK(volume(mesh) > 0);
        CHECK(open_edges(mesh) == 0);
    }
    // A torus of radii 1 and r has the volume 2 pi^2 r^2.
    CHECK(volume(procedural_mesh("procedural://torus?tube=0.5&detail=400")) ==
          doctest::Approx(2 * 9.8696 * 0.25).epsilon(0.001));
    CHECK(volume(procedural_mesh("procedural://rounded_box?x=2&y=3&z=4&radius=0.001")) ==
          doctest::Approx(24).epsilon(0.01));
    // A knot's tube has the same width all along, also where its ends meet.
    CHECK(volume(procedural_mesh("procedural://knot?p=3&q=7&tube=0.1")) > 0);
    CHECK(open_edges(procedural_mesh("procedural://knot?p=3&q=7&tube=0.1")) == 0);
}

TEST_CASE("procedural: other seeds, other shapes; details refine") {
    CHECK_FALSE(procedural_mesh("procedural://terrain?seed=2") ==
                procedural_mesh("procedural://terrain?seed=3"));
    CHECK_FALSE(procedural_mesh("procedural://tree?seed=2&levels=3") ==
                procedural_mesh("procedural://tree?seed=3&levels=3"));
    CHECK(procedural_mesh("procedural://terrain?detail=8").triangles.size() == 128);
    // The cloth lies on the ball and on the floor, nowhere below.
    const auto cloth = share(procedural_mesh("procedural://cloth?detail=24"));
    CHECK(cloth->low.y >= 0);
    CHECK(cloth->low.y < 0.2);
    CHECK(cloth->high.y == doctest::Approx(1.015).epsilon(0.03));
}

TEST_CASE("procedural: what is wrong is told") {
    CHECK(refusal("procedural://teapod").find("did you mean \"teapot\"?") != std::string::npos);
    CHECK(refusal("procedural://knot?pp=2").find("unknown parameter") != std::string::npos);
    CHECK(refusal("procedural://knot?p=two").find("is no parameter") != std::string::npos);
    CHECK(refusal("procedural://knot?p=").find("is no parameter") != std::string::npos);
    CHECK(refusal("procedural://knot?p=2.5").find("whole number") != std::string::npos);
    CHECK(refusal("procedural://terrain?detail=1e9").find("out of range") != std::string::npos);
    CHECK(refusal("procedural://").find("no procedural mesh") != std::string::npos);
}

TEST_CASE("procedural: scene files name them where a path stands, and keep the name") {
    const char* text = R"({"teapath": 1, "objects": [
        {"shape": {"type": "mesh", "file": "procedural://knot?p=2&q=5"}},
        {"shape": {"type": "mesh", "file": "procedural://nothing"}}]})";
    const Scene scene = parse_scene(text, ".", "test");
    const auto& first = std::get<MeshShape>(scene.objects[0].shape).file;
    REQUIRE(first.mesh);
    CHECK(first.mesh->triangles.size() > 100);
    CHECK_FALSE(std::get<MeshShape>(scene.objects[1].shape).file.mesh);
    CHECK(scene_text(scene).find("procedural://knot?p=2&q=5") != std::string::npos);
}
