#include <teapath/core/nearest_name.h>

#include <doctest/doctest.h>

TEST_CASE("edit distance counts single edits and neighbours swapped") {
    CHECK(tp::edit_distance("", "") == 0);
    CHECK(tp::edit_distance("", "abc") == 3);
    CHECK(tp::edit_distance("radius", "radius") == 0);
    CHECK(tp::edit_distance("Radius", "radius") == 0);
    CHECK(tp::edit_distance("raduis", "radius") == 1);
    CHECK(tp::edit_distance("color", "colour") == 1);
    CHECK(tp::edit_distance("sitting", "kitten") == 3);
}

TEST_CASE("the nearest name is found, and nothing where none is near") {
    const std::vector<std::string> names = {"render", "random", "info", "--spp", "--seed"};
    CHECK(tp::nearest_name("rendr", names) == "render");
    CHECK(tp::nearest_name("ranodm", names) == "random");
    CHECK(tp::nearest_name("-spp", names) == "--spp");
    CHECK(tp::nearest_name("--sede", names) == "--seed");
    CHECK(tp::nearest_name("completely", names).empty());
    CHECK(tp::nearest_name("", names).empty());
    CHECK(tp::nearest_name(std::string(100000, 'x'), names).empty());
}
