// The test runner: doctest's options, --backend host|cuda for the tests that render, --long for
// more samples and rays.
#define DOCTEST_CONFIG_IMPLEMENT
#include "support/backend_option.h"

#include <doctest/doctest.h>

#include <cstring>

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--long") == 0) tp::test::long_run() = true;
        if (i + 1 < argc && std::strcmp(argv[i], "--backend") == 0)
            tp::test::backend_name() = argv[i + 1];
    }
    return doctest::Context(argc, argv).run();
}
