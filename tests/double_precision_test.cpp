// T25: what single precision costs. This program renders with every number of the kernels a double
// and compares with the picture of the float program at the same seed.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <teapath/io/image_file.h>
#include <teapath/io/scene_file.h>
#include <teapath/render/session.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace tp;
namespace fs = std::filesystem;

namespace {

static_assert(sizeof(Real) == 8);

constexpr int kSamples = 16;

// The float program's radiance of a scene, by way of a file.
std::vector<float> render_float(const fs::path& scene) {
    const fs::path output =
        fs::temp_directory_path() / fmt::format("teapath_float_{}.exr", std::rand());
    const std::string command =
        fmt::format("\"{}\" render \"{}\" --spp {} --size 120x90 --backend host --quiet -o \"{}\"",
                    TEAPATH_PROGRAM, scene.string(), kSamples, output.string());
    REQUIRE(std::system(command.c_str()) == 0);
    const Image image = read_image(output);
    fs::remove(output);
    const auto* values = reinterpret_cast<const float*>(image.bytes.data());
    std::vector<float> rgb;
    for (int i = 0; i < image.width * image.height; ++i)
        for (int c = 0; c < 3; ++c)
            rgb.push_back(values[i * image.channels + c]);
    return rgb;
}

std::vector<float> render_double(const fs::path& file) {
    Scene scene = load_scene(file);
    scene.render.width = 120;
    scene.render.height = 90;
    SessionOptions options;
    options.backend = BackendKind::Host;
    Session session(options);
    session.sync(std::make_shared<const Scene>(std::move(scene)));
    REQUIRE(session.step(kSamples));
    return session.film().radiance;
}

// Root mean square difference over the root mean square of the picture, and the share of pixels
// that differ by more than a thousandth.
void compare(const char* name) {
    const fs::path scene = fs::path(TEAPATH_SCENES) / name;
    const std::vector<float> a = render_float(scene), b = render_double(scene);
    REQUIRE(a.size() == b.size());
    double squares = 0, norm = 0;
    size_t differing = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const double x = static_cast<double>(a[i]), y = static_cast<double>(b[i]);
        squares += (x - y) * (x - y);
        norm += y * y;
        differing += std::abs(x - y) > 1e-3 * (std::abs(y) + 0.01);
    }
    const double rmse = std::sqrt(squares / norm);
    MESSAGE(name << ": relative RMSE " << 100 * rmse << " %, "
                 << 100.0 * static_cast<double>(differing) / static_cast<double>(a.size())
                 << " % of values differ by more than 0.1 %");
    CHECK(rmse < 0.005);
}

}  // namespace

TEST_CASE("T25: float and double agree within half a percent") {
    compare("cornell_box.json");
}
