#include <teapath/core/parallel.h>

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

TEST_CASE("a loop visits every index once, whatever the number of threads") {
    for (const int threads : {1, 2, 7}) {
        tp::ThreadPool pool(threads);
        std::vector<std::atomic<int>> visits(1000);
        for (int repeat = 0; repeat < 50; ++repeat)
            pool.for_each(1000, [&](int64_t i) { ++visits[static_cast<size_t>(i)]; });
        for (const auto& count : visits)
            CHECK(count == 50);
    }
}

TEST_CASE("an exception in a loop body reaches the caller, and the pool lives on") {
    tp::ThreadPool pool(3);
    CHECK_THROWS_AS(pool.for_each(100,
                                  [](int64_t i) {
                                      if (i == 42) throw std::runtime_error("no");
                                  }),
                    std::runtime_error);
    std::atomic<int> count = 0;
    pool.for_each(10, [&](int64_t) { ++count; });
    CHECK(count == 10);
}
