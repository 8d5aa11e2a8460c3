// What the shaders draw in the viewport, pixel by pixel: picture, ground grid, outline.
#include "fly_camera.h"
#include "viewport/outline.h"
#include "viewport/projection.h"
#include "window_test.h"

#include <teapath/device/pick.h>

#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

using Color = std::array<int, 3>;

// The window's pixels, and where the picture lies in them.
struct Screen {
    explicit Screen(WindowTest& t) {
        pixels = t.draw_and_read(width, height);
        const ImRect rect = ImGui::FindWindowByName("Viewport")->InnerRect;
        x = static_cast<int>(rect.Min.x);
        y = static_cast<int>(rect.Min.y);
        columns = t.app->ui.viewport.width;
        rows = t.app->ui.viewport.height;
    }
    // Of a pixel of the picture.
    Color at(int column, int row) const {
        const auto i = 3 * static_cast<size_t>((y + row) * width + x + column);
        return {pixels[i], pixels[i + 1], pixels[i + 2]};
    }
    ViewRay ray(const Camera& camera, int column, int row) const {
        return view_ray(camera, static_cast<double>(columns) / rows, (column + 0.5) / columns,
                        (row + 0.5) / rows);
    }

    std::vector<uint8_t> pixels;
    int width = 0, height = 0, x = 0, y = 0, columns = 0, rows = 0;
};

int distance(const Color& a, const Color& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

// The render has ended, and nothing is written over its middle.
void settle(WindowTest& t) {
    t.app->ui.preferences.seen_welcome = true;
    t.frames(10);
    REQUIRE(t.frames_until([&] {
        const RenderStatus& status = t.app->status;
        return status.is_done && status.is_resting && !status.is_preview &&
               t.app->texture.width() == t.app->ui.viewport.width;
    }));
    t.frames(2);
}

// Puts a picture of bytes in place of the render, which has ended.
void show_instead(WindowTest& t, int width, int height, std::vector<uint8_t> rgba) {
    settle(t);
    DisplayImage image;
    image.width = width;
    image.height = height;
    image.rgba = std::move(rgba);
    t.app->texture.set_image(std::move(image));
    t.frames(1);
}

constexpr Color kAmberLine = {232, 163, 61};

// A body of eight triangles that is far from filling its box.
Object octahedron(uint32_t id) {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 1}, {0, 0, -1}};
    for (uint32_t x : {0u, 1u})
        for (uint32_t y : {2u, 3u})
            for (uint32_t z : {4u, 5u})
                mesh.triangles.push_back({x, y, z});
    Object object;
    object.id = {id};
    object.name = "octahedron";
    object.shape = MeshShape{{"octahedron.ply", share(mesh)}, {}};
    object.material = {2};
    object.transform.translation = {-0.4, 1.1, 0.6};
    object.transform.rotation = {20, 10, 40};
    object.transform.scale = Double3(0.35);
    return object;
}

}  // namespace

TEST_CASE("layers: T5, T6: each corner of the picture has its colour, nearest and smoothed") {
    WindowTest t;
    t.app->ui.preferences.smooth_picture = false;
    const Color red = {255, 0, 0}, green = {0, 255, 0}, blue = {0, 0, 255}, white = {255, 255, 255};
    show_instead(t, 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
    const Screen nearest(t);
    const int w = nearest.columns, h = nearest.rows;
    // Beside the middle, away from what is written over the picture.
    CHECK(nearest.at(w / 2 - 2, h / 2 - 2) == red);
    CHECK(nearest.at(w / 2 + 2, h / 2 - 2) == green);
    CHECK(nearest.at(w / 2 - 2, h / 2 + 2) == blue);
    CHECK(nearest.at(w / 2 + 2, h / 2 + 2) == white);
    CHECK(nearest.at(w - 1, 0) == green);
    CHECK(nearest.at(0, h - 1) == blue);
    CHECK(nearest.at(w - 1, h - 1) == white);
    t.app->ui.preferences.smooth_picture = true;
    const Screen smooth(t);
    CHECK(distance(smooth.at(w / 2, h / 2), {128, 128, 128}) < 12);
    CHECK(smooth.at(w - 1, h - 1) == white);
}

TEST_CASE("layers: T5: a checker comes back from the screen square by square") {
    WindowTest t;
    t.app->ui.preferences.smooth_picture = false;
    constexpr int kSquares = 8;
    std::vector<uint8_t> rgba;
    for (int i = 0; i < kSquares * kSquares; ++i) {
        const bool is_white = (i + i / kSquares) % 2;
        for (int c = 0; c < 4; ++c)
            rgba.push_back(is_white || c == 3 ? 255 : 0);
    }
    show_instead(t, kSquares, kSquares, rgba);
    const Screen screen(t);
    int wrong = 0;
    for (int row = 2; row < kSquares; ++row) {  // below what is written at the top
        for (int column = 0; column < kSquares; ++column) {
            const int level = (row + column) % 2 ? 255 : 0;
            const Color seen = screen.at((2 * column + 1) * screen.columns / (2 * kSquares),
                                         (2 * row + 1) * screen.rows / (2 * kSquares));
            wrong += seen != Color{level, level, level};
        }
    }
    CHECK(wrong == 0);
}

namespace {

void check_outlines(const Camera& view) {
    Scene scene = small_scene();
    Object box;
    box.id = {5};
    box.name = "box";
    box.shape = BoxShape{{-0.4, 0, -0.4}, {0.4, 0.7, 0.4}};
    box.transform.rotation = {10, 30, 0};
    box.transform.translation = {0.7, 0.3, 0.9};
    box.material = {2};
    scene.objects.edit().push_back(box);
    Object disk = box;
    disk.id = {6};
    disk.name = "disk";
    disk.shape = DiskShape{{-0.7, 1.4, 0.3}, {0.3, 0.2, 1}, 0.5};
    disk.transform = {};
    scene.objects.edit().push_back(disk);
    scene.cameras = {view};
    WindowTest t(scene);
    t.app->document.edit("Add", "", [](Scene& s) { s.objects.edit().push_back(octahedron(7)); });
    settle(t);
    for (const Object& object : t.scene().objects)
        t.app->document.select(object.id, true);
    t.app->ui.viewport.tool = Tool::Select;
    const Screen screen(t);
    t.screenshot("outline");

    SceneArrays arrays;
    flatten(t.scene(), SceneParts::All, arrays);
    const Camera camera = t.camera();
    std::vector<uint32_t> ids;
    for (int row = 0; row < screen.rows; ++row) {
        for (int column = 0; column < screen.columns; ++column) {
            const ViewRay ray = screen.ray(camera, column, row);
            ids.push_back(pick(arrays, ray.origin, ray.direction, 1e9).object.value);
        }
    }
    const auto differing = [&](int column, int row, int distance) {
        int count = 0;
        for (int dy = -distance; dy <= distance; ++dy)
            for (int dx = -distance; dx <= distance; ++dx)
                count += ids[static_cast<size_t>((row + dy) * screen.columns + column + dx)] !=
                         ids[static_cast<size_t>(row * screen.columns + column)];
        return count;
    };
    int lines = 0, missing = 0, wrong = 0;
    for (int row = 60; row < screen.rows - 60; ++row) {  // between what is written
        for (int column = 4; column < screen.columns - 4; ++column) {
            const bool is_line = distance(screen.at(column, row), kAmberLine) < 8;
            if (differing(column, row, 1) >= 3) {
                ++lines;
                missing += !is_line;
            } else if (differing(column, row, 2) == 0) {
                wrong += is_line;
            }
        }
    }
    MESSAGE(lines << " pixels of lines, missing " << missing << ", wrong " << wrong);
    CHECK(lines > 1000);
    // Rounding decides for single pixels.
    CHECK(missing <= lines / 200);
    CHECK(wrong <= lines / 200);
}

}  // namespace

TEST_CASE("layers: outlines are exactly where rays meet another object than beside") {
    check_outlines(small_scene().cameras[0]);
}

TEST_CASE("layers: outlines, with a shifted film and with parallel rays") {
    Camera camera = small_scene().cameras[0];
    camera.shift = {0.08, -0.05};
    check_outlines(camera);
    camera.projection = ProjectionKind::Orthographic;
    camera.film_height = 4;
    check_outlines(camera);
}

TEST_CASE("layers: the ground grid's axes lie where the ground's points are seen") {
    WindowTest t;
    settle(t);
    const Screen before(t);
    t.app->ui.preferences.ground_grid = true;
    const Screen after(t);
    t.screenshot("ground_grid");
    const Camera camera = t.camera();
    const double aspect = static_cast<double>(after.columns) / after.rows;
    const auto change = [&](const Double3& point) {
        const Double4 clip = clip_from_world(camera, aspect) * Double4(point, 1);
        const int column = static_cast<int>((clip.x / clip.w + 1) / 2 * after.columns);
        const int row = static_cast<int>((1 - clip.y / clip.w) / 2 * after.rows);
        Color sum = {0, 0, 0};  // over the pixels that the line may fall on
        for (int i = -1; i <= 1; ++i)
            for (int c = 0; c < 3; ++c)
                sum[static_cast<size_t>(c)] +=
                    after.at(column + i, row + i)[static_cast<size_t>(c)] -
                    before.at(column + i, row + i)[static_cast<size_t>(c)];
        return sum;
    };
    const Color on_z = change({0, 0, 1.5}), on_x = change({2, 0, 0}),
                beside = change({0.45, 0, 1.45});
    CHECK(on_z[2] > on_z[0] + 60);
    CHECK(on_x[0] > on_x[2] + 60);
    CHECK(distance(beside, {0, 0, 0}) == 0);
    // A camera on the ground, below it and far away: nothing goes wrong.
    for (const double y : {0.0, -3.0, 1e7}) {
        Camera moved = camera;
        moved.look_from.y = y;
        t.app->document.fly(moved);
        t.frames(2);
    }
    int width = 0, height = 0;
    t.draw_and_read(width, height);
}

TEST_CASE("layers: ten thousand selected objects cost a frame, not a second") {
    Scene scene = small_scene();
    const Object ball = scene.objects.back();
    for (uint32_t i = 0; i < 10000; ++i) {
        Object copy = ball;
        copy.id = {100 + i};
        copy.name = "ball " + std::to_string(i);
        copy.shape = SphereShape{{0.2 * (i % 100) - 10, 0.1, -0.2 * (i / 100)}, 0.08};
        scene.objects.edit().push_back(copy);
    }
    WindowTest t(scene);
    PanelContext context = t.context();
    run_action("edit.select_all", context);
    t.frames(3);
    t.screenshot("selected_10000");
    CHECK(t.app->document.selection.size() == scene.objects.size());
}
