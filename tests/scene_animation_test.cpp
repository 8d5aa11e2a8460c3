// Keyframes against closed forms, and meshes that change their form.
#include <teapath/scene/animation.h>
#include <teapath/scene/deform.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace tp;

namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

bool is_near(Double3 a, Double3 b, double error = 1e-6) {
    return glm::length(a - b) < error;
}

Double4 turn_about_y(double degrees) {
    const double half = degrees * kHalfTurn / 360;
    return {0, std::sin(half), 0, std::cos(half)};
}

}  // namespace

TEST_CASE("animation: linear keyframes, held before the first and after the last") {
    const AnimationSampler s{Interpolation::Linear, 3, {1, 3}, {0, 0, 0, 2, -4, 8}};
    CHECK(is_near(sample_vector(s, 0), {0, 0, 0}));
    CHECK(is_near(sample_vector(s, 1), {0, 0, 0}));
    CHECK(is_near(sample_vector(s, 1.5), {0.5, -1, 2}));
    CHECK(is_near(sample_vector(s, 3), {2, -4, 8}));
    CHECK(is_near(sample_vector(s, 100), {2, -4, 8}));
}

TEST_CASE("animation: a step holds its value up to the next keyframe") {
    const AnimationSampler s{Interpolation::Step, 1, {0, 1, 2}, {5, 6, 7}};
    CHECK(sample_numbers(s, 0.999)[0] == 5);
    CHECK(sample_numbers(s, 1)[0] == 6);
    CHECK(sample_numbers(s, 1.999)[0] == 6);
    CHECK(sample_numbers(s, 2)[0] == 7);
}

TEST_CASE("animation: a cubic spline follows the cubic that its tangents describe") {
    // f(t) = t^3 - 2 t + 1, its value and slope at 0, 1 and 3: Hermite's form is exact.
    const auto f = [](double t) { return t * t * t - 2 * t + 1; };
    const auto slope = [](double t) { return 3 * t * t - 2; };
    AnimationSampler s{Interpolation::CubicSpline, 1, {0, 1, 3}, {}};
    for (const double t : {0.0, 1.0, 3.0})
        for (const double number : {slope(t), f(t), slope(t)})
            s.values.push_back(static_cast<float>(number));
    for (double t = 0; t <= 3; t += 0.125)
        CHECK(sample_numbers(s, t)[0] == doctest::Approx(f(t)).epsilon(1e-6));
}

TEST_CASE("animation: rotations turn evenly along the shorter way") {
    const auto keys = [](Double4 a, Double4 b, Interpolation rule) {
        AnimationSampler s{rule, 4, {0, 1}, {}};
        for (const Double4& q : {a, b})
            for (int i = 0; i < 4; ++i)
                s.values.push_back(static_cast<float>(q[i]));
        return s;
    };
    const auto angle = [](Double4 q) { return 2 * std::atan2(q.y, q.w) * 180 / kHalfTurn; };
    const AnimationSampler even = keys(turn_about_y(10), turn_about_y(150), Interpolation::Linear);
    for (double t = 0; t <= 1; t += 0.1)
        CHECK(angle(sample_rotation(even, t)) == doctest::Approx(10 + 140 * t).epsilon(1e-5));
    // -q is the same rotation.
    const AnimationSampler other = keys(turn_about_y(10), -turn_about_y(50), Interpolation::Linear);
    CHECK(angle(sample_rotation(other, 0.5)) == doctest::Approx(30).epsilon(1e-5));
    const AnimationSampler same = keys(turn_about_y(20), turn_about_y(20), Interpolation::Linear);
    CHECK(angle(sample_rotation(same, 0.3)) == doctest::Approx(20).epsilon(1e-5));
    const AnimationSampler steps = keys(turn_about_y(10), turn_about_y(50), Interpolation::Step);
    CHECK(angle(sample_rotation(steps, 0.9)) == doctest::Approx(10).epsilon(1e-5));
}

TEST_CASE("animation: cubic rotations are unit quaternions") {
    AnimationSampler s{Interpolation::CubicSpline, 4, {0, 1}, {}};
    for (const Double4& q : {turn_about_y(0), turn_about_y(90)})
        for (const Double4& row : {Double4(0), q, Double4(0)})
            for (int i = 0; i < 4; ++i)
                s.values.push_back(static_cast<float>(row[i]));
    const Double4 middle = sample_rotation(s, 0.5);
    CHECK(glm::length(middle) == doctest::Approx(1));
    CHECK(2 * std::atan2(middle.y, middle.w) * 180 / kHalfTurn == doctest::Approx(45));
}

TEST_CASE("animation: targets add, joints blend, mirrored meshes keep their fronts") {
    DeformableMesh d;
    d.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    d.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    d.mesh.triangles = {{0, 1, 2}};
    d.targets = {{{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}, {}, {}}, {{}, {{1, 0, 0}, {}, {}}, {}}};
    d.skin.joints = {{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}}};
    d.skin.weights = {{{0.5f, 0.5f, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0}}};
    CHECK(problem_of(d, 2) == "");
    CHECK(problem_of(d, 1) != "");
    CHECK(d.bytes() > bytes_of(d.mesh));

    const Mesh morphed = deformed(d, {0.5, 1}, {}, true);
    CHECK(is_near(morphed.positions[2], {0, 1, 1.5}));
    CHECK(is_near(morphed.normals[0], {std::sqrt(0.5), 0, std::sqrt(0.5)}));

    DoubleMat4 up(1);
    up[3] = Double4(0, 2, 0, 1);
    const Mesh skinned = deformed(d, {}, {DoubleMat4(1), up}, false);
    CHECK(is_near(skinned.positions[0], {0, 1, 0}));  // half of each
    CHECK(is_near(skinned.positions[1], {1, 2, 0}));  // the second alone
    CHECK(is_near(skinned.positions[2], {0, 1, 0}));  // the first, its weight made 1
    CHECK(skinned.triangles[0] == std::array<uint32_t, 3>{0, 1, 2});

    DoubleMat4 mirror(1);
    mirror[0][0] = -1;
    const Mesh mirrored = deformed(d, {}, {mirror, mirror}, false);
    CHECK(is_near(mirrored.positions[1], {-1, 0, 0}));
    CHECK(mirrored.triangles[0] == std::array<uint32_t, 3>{0, 2, 1});
}
