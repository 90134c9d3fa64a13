#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

/// Returns the error message for a text that names no reproduction, or "".
std::string refusal(const std::string& text) {
    try {
        Reproduction::named(text);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("a text names a policy, with its numbers by position or by name") {
    for (const char* text : {"tournament(3)", " tournament ( size=3 ) ", "tournament(size = 3)"})
        CHECK(Reproduction::named(text).text() == "tournament(size = 3)");
    CHECK(Reproduction::named("tournament").text() == "tournament(size = 2)");
    CHECK(Reproduction::named("ranking(1.25)").text() == "ranking(best = 1.25)");
    CHECK(Reproduction().text() == "roulette");
    CHECK(Crossover().text() == "one-point");
}

TEST_CASE("the text that a policy prints names the same policy") {
    for (const PolicyDescription& way : Reproduction::descriptions())
        CHECK(Reproduction::named(way.text()).text() == way.text());
    for (const PolicyDescription& way : Crossover::descriptions())
        CHECK(Crossover::named(way.text()).text() == way.text());
}

TEST_CASE("a text that names no policy is refused with the existing policies") {
    CHECK(refusal("tournment") == "\"tournment\" is not one of roulette, universal, scaled(best = 2), ranking(best = "
                                  "2), tournament(size = 2); did you mean \"tournament\"?");
    CHECK(refusal("").starts_with("\"\" is not one of roulette"));
    CHECK(refusal("tournament(3") == "\"tournament(3\" has no closing parenthesis at its end");
    CHECK(refusal("tournament()") == "\"\" is not a number: size is a whole number from 1 to 1000000");
    CHECK(refusal("tournament(2.5)") == "size = 2.5 is out of range: size is a whole number from 1 to 1000000");
    CHECK(refusal("tournament(0)") == "size = 0 is out of range: size is a whole number from 1 to 1000000");
    CHECK(refusal("ranking(nan)") == "best = nan is out of range: best is a number from 1 to 2");
    CHECK(refusal("ranking(2, 3)") == "ranking takes at most 1 number: best is a number from 1 to 2");
    CHECK(refusal("ranking(2, best = 2)") == "best of ranking is given twice");
    CHECK(refusal("ranking(pressure = 2)") ==
          "ranking has no number \"pressure\"; ranking takes at most 1 number: best is a number from 1 to 2");
    CHECK(refusal("roulette(2)") == "roulette takes no number");
}
