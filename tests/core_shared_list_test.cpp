// Copies of a list share their elements until one of them changes.
#include <teapath/core/shared_list.h>

#include <doctest/doctest.h>

using tp::SharedList;

TEST_CASE("shared list: copies are one until one of them changes") {
    SharedList<int> list{1, 2, 3};
    SharedList<int> copy = list;
    CHECK(&copy.items() == &list.items());
    CHECK(copy == list);
    copy.edit()[0] = 9;
    CHECK(list.items() == std::vector<int>{1, 2, 3});
    CHECK(copy.items() == std::vector<int>{9, 2, 3});
    CHECK(copy != list);
    // Alone, it changes in place; equal elements make equal lists.
    const std::vector<int>* own = &copy.items();
    copy.edit()[0] = 1;
    CHECK(&copy.items() == own);
    CHECK(copy == list);
}

TEST_CASE("shared list: an empty one and one that was moved from") {
    SharedList<int> list;
    CHECK(list.empty());
    CHECK(list == SharedList<int>(std::vector<int>{}));
    list.edit().push_back(5);
    const SharedList<int> taken = std::move(list);
    CHECK(taken.back() == 5);
    CHECK(list.empty());
    list.edit().push_back(6);
    CHECK(list.size() == 1);
    CHECK(taken.size() == 1);
}
