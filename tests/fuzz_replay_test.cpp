// The fuzzers' corpora, whole, cut short at every length, and with every byte changed.
#include "fuzz/fuzz_mesh.h"
#include "fuzz/fuzz_model.h"
#include "support/shipped_scenes.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

using Fuzzer = bool (*)(const uint8_t*, size_t);

bool holds(Fuzzer fuzzer, const std::string& input) {
    return fuzzer(reinterpret_cast<const uint8_t*>(input.data()), input.size());
}

void replay(Fuzzer fuzzer, const char* kind, int least_files) {
    int files = 0;
    const std::filesystem::path folder =
        std::filesystem::path(TEAPATH_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / kind;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        ++files;
        const std::string input = text_of(entry.path());
        CAPTURE(entry.path().string());
        CHECK(holds(fuzzer, input));
        for (size_t length = 0; length < input.size(); ++length)
            CHECK(holds(fuzzer, input.substr(0, length)));
        for (size_t i = 1; i < input.size(); ++i) {
            std::string changed = input;
            changed[i] = static_cast<char>(changed[i] ^ 0x11);
            CHECK(holds(fuzzer, changed));
            changed[i] = '\xff';
            CHECK(holds(fuzzer, changed));
        }
    }
    CHECK(files >= least_files);
}

}  // namespace

TEST_CASE("fuzz: the corpus of mesh files is taken or refused, also cut short and changed") {
    replay(fuzz_mesh, "mesh", 6);
}

TEST_CASE("fuzz: the corpus of glTF files is taken or refused, also cut short and changed") {
    replay(fuzz_gltf, "gltf", 6);
}

TEST_CASE("fuzz: the corpus of OBJ models is taken or refused, also cut short and changed") {
    replay(fuzz_obj_model, "obj_model", 2);
}

TEST_CASE("fuzz: the corpus of images is taken or refused, also cut short and changed") {
    replay(fuzz_image, "image", 8);
}
