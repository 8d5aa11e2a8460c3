// T23: what loading ten thousand objects takes. Times are reported, not asserted.
#include <teapath/device/scene_arrays.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr int kObjects = 10000;

// A scene file with that many spheres, each written out, with a material of its own.
fs::path write_scene() {
    const fs::path file = fs::temp_directory_path() / fmt::format("teapath_load_{}.json", getpid());
    std::ofstream out(file);
    out << R"({"teapath": 1, "materials": {)";
    for (int i = 0; i < kObjects; ++i)
        out << fmt::format(R"({}"m{}": {{"type": "lambertian", "color": [0.5, 0.25, {}]}})",
                           i ? ",\n" : "", i, i * 1e-5);
    out << R"(}, "objects": [)";
    for (int i = 0; i < kObjects; ++i)
        out << fmt::format(
            R"({}{{"shape": {{"type": "sphere", "center": [{}, 0, {}], "radius": 0.4}}, "material": "m{}"}})",
            i ? ",\n" : "", i % 100, i / 100, i);
    out << "]}";
    return file;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

TEST_CASE("T23: ten thousand objects are read, packed and in their tree") {
    const fs::path file = write_scene();
    const auto start = std::chrono::steady_clock::now();
    const Scene scene = load_scene(file);
    const double read = milliseconds_since(start);
    SceneArrays arrays;
    flatten(scene, SceneParts::All, arrays);
    const double all = milliseconds_since(start);
    fs::remove(file);
    MESSAGE("10,000 objects: file read in " << read << " ms, packed with their tree in "
                                            << all - read << " ms");
    CHECK(scene.objects.size() == kObjects);
    CHECK(arrays.hittables.size() == kObjects);
    CHECK(arrays.materials.size() == kObjects + 1);
    CHECK(arrays.bvh.leaf_count > kObjects / static_cast<int>(kMaxLeafSize));

    // Every record is in one of seven arrays: nothing is allocated for an object alone.
    CHECK(arrays.bytes() ==
          kObjects * sizeof(Hittable) + arrays.nodes.size() * sizeof(BvhNode) +
              arrays.materials.size() * (sizeof(MaterialRecord) + sizeof(uint32_t)));
}
