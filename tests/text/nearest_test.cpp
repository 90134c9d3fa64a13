#include "text/nearest.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("a missing, extra, replaced or swapped letter is one edit") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("master", "master") == 0);
    CHECK(edit_distance("mastr", "master") == 1);
    CHECK(edit_distance("masster", "master") == 1);
    CHECK(edit_distance("mister", "master") == 1);
    CHECK(edit_distance("amster", "master") == 1);
    CHECK(edit_distance("slave", "master") == 5);
}

TEST_CASE("the nearest name is found if it is near enough") {
    const std::vector<std::string> names{"slave", "master", "Host", "ga.master"};
    CHECK(nearest_name("mastr", names) == "master");
    CHECK(nearest_name("MASTER", names) == "master");
    CHECK(nearest_name("host", names) == "Host");
    CHECK(nearest_name("island", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name("master", {"master"}).empty()); // the name exists, so something else is wrong
    CHECK(nearest_name("ab", {"ac", "ad"}) == "ac");   // the first of equally near names
    CHECK(nearest_name("a", {"b", "ab"}).empty());
    CHECK(nearest_name("wire", {"size"}).empty()); // two of four letters differ
    CHECK(nearest_name("procesor", {"PROCESSOR", "processor"}) == "processor");
    CHECK(nearest_name("PROCESOR", {"processor", "PROCESSOR"}) == "PROCESSOR");
    CHECK(nearest_name(std::string(1000, 'x'), {std::string(1001, 'x')}).empty());
}

TEST_CASE("an abbreviation means the only name that begins with it") {
    const std::vector<std::string> kinds{"csp.fork", "csp.prefix", "csp.producer"};
    CHECK(nearest_name("csp.prod", kinds) == "csp.producer"); // csp.fork is nearer, but not near enough
    CHECK(nearest_name("CSP.Prod", kinds) == "csp.producer");
    CHECK(nearest_name("csp.pr", kinds).empty()); // neither of two equally near names
    CHECK(nearest_name("csp.forks", kinds) == "csp.fork");
    CHECK(nearest_name("PROCESS", {"process", "processor"}) == "process");
    CHECK(nearest_name("ex", {"excavator"}).empty());
    CHECK(nearest_name("exc", {"excavator", "excavator"}) == "excavator");
}

TEST_CASE("a name without its group means the name with it") {
    CHECK(nearest_name("worker", {"csp.coworker", "works", "csp.worker", "ga.worker"}) == "csp.worker");
    CHECK(nearest_name("orker", {"csp.worker"}).empty());
    CHECK(nearest_name("", {"csp."}).empty());
}

TEST_CASE("a nearest name is printed as a hint") {
    CHECK(did_you_mean("mastr", {"slave", "master"}) == "did you mean \"master\"?");
    CHECK(did_you_mean("island", {"slave", "master"}).empty());
    CHECK(unknown_name("kind", "mastr", {"slave", "master"}, "ask again") ==
          "unknown kind \"mastr\"; did you mean \"master\"?");
    CHECK(unknown_name("kind", "island", {"slave", "master"}, "ask again") == "unknown kind \"island\"; ask again");
}
