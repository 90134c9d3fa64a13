#include "text/meaning.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

const std::vector<NamedMeaning> experiments_to_find{
    {"figures-4-6-4-7", "speedup of algorithm A with and without a pipeline"},
    {"figure-4-9", "the boom's compliance identified on 16 transputers"},
    {"pga-1", "islands that exchange in turns (Figure 5.3)"},
    {"coarse-fine", "a coarse and a fine search: Tables 6.3, 6.4"},
    {"table-e2", "the speedup of algorithms B, A, and A + B"},
};

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("a figure is found by one of its numbers") {
    CHECK(names_by_meaning("figure-4-6", experiments_to_find) == Names{"figures-4-6-4-7"});
    CHECK(names_by_meaning("Figure 4.7", experiments_to_find) == Names{"figures-4-6-4-7"});
    CHECK(names_by_meaning("fig-5-3", experiments_to_find).empty()); // three letters do not make a word
    CHECK(names_by_meaning("figure-5-3", experiments_to_find) == Names{"pga-1"});
    CHECK(names_by_meaning("table-6-4", experiments_to_find) == Names{"coarse-fine"});
    CHECK(names_by_meaning("figure-4-3", experiments_to_find).empty());
    CHECK(names_by_meaning("figure-7-4", experiments_to_find).empty()); // both numbers are there, but not in this order
}

TEST_CASE("all words must be there, in any inflection") {
    CHECK(names_by_meaning("speedup", experiments_to_find) == Names{"figures-4-6-4-7", "table-e2"});
    CHECK(names_by_meaning("speedup of pipelines", experiments_to_find) == Names{"figures-4-6-4-7"});
    CHECK(names_by_meaning("identification", experiments_to_find) == Names{"figure-4-9"});
    CHECK(names_by_meaning("speedup of islands", experiments_to_find).empty());
    CHECK(names_by_meaning("everything", {{"pga-2", "every generation"}}).empty());
    CHECK(names_by_meaning("", experiments_to_find).empty());
    CHECK(names_by_meaning("4-6", experiments_to_find).empty()); // of what?
}

TEST_CASE("meaning comes before spelling, and several names are offered") {
    CHECK(unknown_meaning("experiment", "figure-4-6", experiments_to_find, "") ==
          "unknown experiment \"figure-4-6\"; did you mean \"figures-4-6-4-7\"?");
    CHECK(unknown_meaning("experiment", "speedup", experiments_to_find, "") ==
          "unknown experiment \"speedup\"; did you mean \"figures-4-6-4-7\", or \"table-e2\"?");
    CHECK(unknown_meaning("experiment", "tabel-e2", experiments_to_find, "") ==
          "unknown experiment \"tabel-e2\"; did you mean \"table-e2\"?");
    CHECK(unknown_meaning("experiment", "xyz", experiments_to_find, "none") == "unknown experiment \"xyz\"; none");
    const std::vector<NamedMeaning> many(4, {"a", "speedup"});
    CHECK(unknown_meaning("experiment", "speedups", many, "there are four") ==
          "unknown experiment \"speedups\"; there are four");
}
