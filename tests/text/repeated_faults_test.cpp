#include "text/repeated_faults.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

std::vector<Diagnostic> gaps(std::size_t first, std::size_t last) {
    std::vector<Diagnostic> faults;
    for (std::size_t line = first; line <= last; ++line)
        faults.push_back(warning_at(line, 1, "the step is " + std::to_string(line) + ".5e-3 s", "a hint"));
    return faults;
}

} // namespace

TEST_CASE("faults that differ only in numbers are one message with its count") {
    RepeatedFaults repeated;
    const std::vector<Diagnostic> first = repeated.take(gaps(3, 8));
    REQUIRE(first.size() == 1);
    CHECK(first[0].location.line == 3);
    CHECK(first[0].message == "the step is 3.5e-3 s (and 5 more lines, the last is line 8)");
    CHECK(first[0].hint == "a hint");
    CHECK(repeated.later().empty());
    CHECK(repeated.take(gaps(9, 11)).empty());
    CHECK(repeated.take(gaps(12, 12)).empty());
    CHECK(repeated.later() == "... 4 more lines like \"the step is 3.5e-3 s\", the last is line 12\n");
    CHECK(RepeatedFaults().take(gaps(3, 4))[0].message == "the step is 3.5e-3 s (and line 4)");
}

TEST_CASE("two faults of one kind in a line are one line") {
    RepeatedFaults repeated;
    std::vector<Diagnostic> faults;
    for (std::size_t line : {4U, 4U, 5U, 5U})
        faults.push_back(warning_at(line, 1, "the step is 1 s", "a hint"));
    CHECK(repeated.take(faults)[0].message == "the step is 1 s (and line 5)");
    for (Diagnostic& each : faults)
        each.location.line += 2;
    CHECK(repeated.take(faults).empty());
    CHECK(repeated.later() == "... 2 more lines like \"the step is 1 s\", the last is line 7\n");
}

TEST_CASE("faults of one line, of other words or of other names stay apart") {
    const std::vector<Diagnostic> faults{error_at(2, 1, "no value"),
                                         error_at(2, 5, "no value"),
                                         error_at(3, 1, "\"x\" is not a number"),
                                         error_at(4, 1, "\"y\" is not a number"),
                                         error_at(5, 1, "P1 freezes"),
                                         error_at(6, 1, "P2 freezes")};
    RepeatedFaults repeated;
    const std::vector<Diagnostic> shown = repeated.take(faults);
    REQUIRE(shown.size() == 6);
    for (std::size_t i = 0; i < shown.size(); ++i)
        CHECK(shown[i].message == faults[i].message);
}
