// What a session counts while it traces.
#include "support/scene_maker.h"

using namespace tp;
using namespace tp::test;

namespace {

RenderCounters counters_of(const Scene& scene, int64_t samples) {
    Session session(session_options(false));
    session.sync(std::make_shared<const Scene>(scene));
    REQUIRE(session.step(samples));
    return session.counters();
}

}  // namespace

TEST_CASE("rays: one where nothing is met; segments of paths and queries for light are counted") {
    SceneMaker empty;
    empty.background(1);
    const RenderCounters sky = counters_of(empty.scene, 7);
    CHECK(sky.samples == 7 * static_cast<uint64_t>(empty.scene.render.width) *
                             static_cast<uint64_t>(empty.scene.render.height));
    CHECK(sky.rays == sky.samples);

    // Inside of a white ball a path ends at its depth, and nowhere else.
    SceneMaker closed;
    closed.sphere({0, 0, 0}, 100, closed.lambertian(1));
    closed.scene.render.path.max_depth = 5;
    closed.scene.render.path.roulette_depth = 0;
    const RenderCounters inside = counters_of(closed.scene, 3);
    CHECK(inside.rays == 5 * inside.samples);

    // A light in there: at most one query from each surface but the last.
    closed.sphere({0, 50, 0}, 1, closed.light(1));
    const RenderCounters lit = counters_of(closed.scene, 3);
    CHECK(lit.rays > inside.rays);
    CHECK(lit.rays <= 9 * lit.samples);
}
