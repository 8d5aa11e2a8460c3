// The fuzzers' corpus, whole, cut short at every length, and with every byte changed.
#include "fuzz/fuzz_mesh.h"
#include "support/shipped_scenes.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

bool holds(const std::string& input) {
    return fuzz_mesh(reinterpret_cast<const uint8_t*>(input.data()), input.size());
}

}  // namespace

TEST_CASE("fuzz: the corpus of mesh files is taken or refused, also cut short and changed") {
    int files = 0;
    const std::filesystem::path folder =
        std::filesystem::path(TEAPATH_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / "mesh";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        ++files;
        const std::string input = text_of(entry.path());
        CAPTURE(entry.path().string());
        CHECK(holds(input));
        for (size_t length = 0; length < input.size(); ++length)
            CHECK(holds(input.substr(0, length)));
        for (size_t i = 1; i < input.size(); ++i) {
            std::string changed = input;
            changed[i] = static_cast<char>(changed[i] ^ 0x11);
            CHECK(holds(changed));
            changed[i] = '\xff';
            CHECK(holds(changed));
        }
    }
    CHECK(files >= 6);
}
