#include "text/positions.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>

namespace placedpar {

TEST_CASE("positions count units of UTF-16") {
    const std::string text = "a\xc3\xa9\xf0\x9f\x98\x80z\r\n\rb\n"; // aé😀z, an empty line, b, an empty line
    const Positions positions(text);
    REQUIRE(positions.lines() == 4);
    for (auto [line, character, offset] : {std::tuple{0, 0, 0},
                                           {0, 1, 1},
                                           {0, 2, 3},
                                           {0, 4, 7},
                                           {0, 5, 8},
                                           {1, 0, 10},
                                           {2, 0, 11},
                                           {2, 1, 12},
                                           {3, 0, 13}}) {
        const Position at{static_cast<std::size_t>(line), static_cast<std::size_t>(character)};
        CHECK(positions.offset(at) == static_cast<std::size_t>(offset));
        const Position back = positions.position(static_cast<std::size_t>(offset));
        CHECK(back.line == at.line);
        CHECK(back.character == at.character);
    }
    CHECK(positions.offset({0, 3}) == 3); // in the middle of the pair
    CHECK(positions.offset({0, 99}) == 8);
    CHECK(positions.offset({4, 0}) == text.size());
    CHECK_THROWS_AS(positions.offset({5, 0}), std::out_of_range);
    const std::string latin = "\xe9x";
    CHECK(Positions(latin).offset({0, 1}) == 1);
}

TEST_CASE("a word ends behind its last character") {
    const auto end = [](NamesOf language, const std::string& text, std::size_t column) {
        return end_of_word({std::make_shared<const SourceFile>("a.inc", text), 1, column}, language).column;
    };
    CHECK(end(NamesOf::netlist, "ring.out = 3", 1) == 5);
    CHECK(end(NamesOf::occam, "ring.out. = 3", 1) == 9);
    CHECK(end(NamesOf::netlist, "use \"a b\" for", 5) == 10);
    CHECK(end(NamesOf::netlist, "use \"a b", 5) == 9);
    CHECK(end(NamesOf::netlist, ";;", 1) == 2);
    CHECK(end(NamesOf::netlist, "\xf0\x9f\x98\x80", 1) == 5);
    CHECK(end(NamesOf::netlist, "ab", 3) == 3);
    CHECK(end(NamesOf::netlist, "ab", 9) == 9);
}

} // namespace placedpar
