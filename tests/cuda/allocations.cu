// T23: a scene on a CUDA device is one allocation, however many objects it has. The runner is
// linked with --wrap=cudaMalloc, so that every allocation of the program comes by here.
#include "support/scene_maker.h"

#include <cuda_runtime.h>

#include <atomic>

namespace {
std::atomic<int> allocations = 0;
}  // namespace

extern "C" {
cudaError_t __real_cudaMalloc(void** memory, size_t bytes);
cudaError_t __wrap_cudaMalloc(void** memory, size_t bytes);

cudaError_t __wrap_cudaMalloc(void** memory, size_t bytes) {
    ++allocations;
    return __real_cudaMalloc(memory, bytes);
}
}

namespace tp::test {
namespace {

// Allocations of a session that takes a scene of `count` spheres and renders a sample of it.
int allocations_of(int count) {
    SceneMaker maker;
    maker.background(1);
    for (int i = 0; i < count; ++i)
        maker.sphere({i % 100 * 3.0, i / 100 * 3.0, 0}, 1, maker.lambertian(0.5));
    SessionOptions options;
    options.backend = BackendKind::Cuda;
    const int before = allocations;
    Session session(options);
    session.sync(std::make_shared<const Scene>(maker.scene));
    REQUIRE(session.step(1));
    return allocations - before;
}

}  // namespace

TEST_CASE("T23: allocations on a device do not grow with the number of objects") {
    if (backend_name() != "cuda") return;
    const int few = allocations_of(10), many = allocations_of(10000);
    MESSAGE("device allocations of a render: " << many << " for 10,000 objects");
    CHECK(few == many);
    CHECK(many <= 8);
}

}  // namespace tp::test
