#include "text/diagnostic.hpp"

#include "text/reporter.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

std::shared_ptr<const SourceFile> file(std::string text) {
    return std::make_shared<const SourceFile>("a.txt", std::move(text));
}

Diagnostic error(const Location& location) { return {.message = "this is wrong", .location = location}; }

} // namespace

TEST_CASE("a diagnostic as compilers print it, with its hint and its second places") {
    auto source = file("first a\n\tsecond a\n");
    Diagnostic diagnostic = error({source, 2, 9});
    diagnostic.hint = "say b";
    diagnostic.others = {{"a is here", {source, 1, 7}}};
    CHECK(render(diagnostic) == "a.txt:2:9: error: this is wrong\n"
                                "    \tsecond a\n"
                                "    \t       ^\n"
                                "hint: say b\n"
                                "a.txt:1:7: note: a is here\n"
                                "    first a\n"
                                "          ^\n");
}

TEST_CASE("a whole file, and no place at all") {
    CHECK(render(error({file(""), 0, 0})) == "a.txt: error: this is wrong\n");
    CHECK(render(error({})) == "error: this is wrong\n");
    CHECK(render(warning_at(3, 4, "this is odd")) == "warning: this is odd\n");
    CHECK(render(std::vector{error_at(0, 0, "one"), error_at(0, 0, "two")}) == "error: one\nerror: two\n");
}

TEST_CASE("the caret takes characters for columns, and a terminal gets nothing to act on") {
    CHECK(render(error({file("\xc3\xa4\xc3\xb6 @"), 1, 6})) == "a.txt:1:6: error: this is wrong\n"
                                                               "    \xc3\xa4\xc3\xb6 @\n"
                                                               "       ^\n");
    CHECK(render(error({file("\x1b[2J @"), 1, 6})) == "a.txt:1:6: error: this is wrong\n"
                                                      "    ?[2J @\n"
                                                      "         ^\n");
}

TEST_CASE("a long line is shown around the caret") {
    std::string text = render(error({file(std::string(300, 'x') + "@" + std::string(300, 'x')), 1, 301}));
    std::size_t line = text.find("    ...x"), caret_line = text.find('\n', line) + 1;
    REQUIRE(line != std::string::npos);
    CHECK(text.substr(line, caret_line - line).ends_with("x...\n"));
    CHECK(text.find('@') - line == text.find('^') - caret_line);
    CHECK(text.find('^') - caret_line < 100);
}

TEST_CASE("a reporter keeps one error a place, and gives up after twenty") {
    Reporter reporter;
    auto source = file("a");
    reporter.warning({source, 1, 1}, "odd");
    CHECK_FALSE(reporter.failed());
    reporter.error({source, 1, 1}, "wrong");
    reporter.error({source, 1, 1}, "wrong again");
    CHECK(reporter.failed());
    auto fill = [&] {
        for (std::size_t line = 2; line < 100; ++line)
            reporter.error({source, line, 1}, "wrong");
    };
    CHECK_THROWS_AS(fill(), GiveUp);
    auto diagnostics = reporter.take();
    CHECK(diagnostics.size() == 1 + most_errors);
    CHECK(diagnostics[1].message == "wrong");
    CHECK(has_errors(diagnostics));
}

TEST_CASE("errors at one place come to an end, too") {
    Reporter reporter;
    auto repeat = [&, source = file("a")] {
        for (int i = 0; i < 1000; ++i)
            reporter.error({source, 1, 1}, "wrong");
    };
    CHECK_THROWS_AS(repeat(), GiveUp);
    CHECK(reporter.take().size() == 1);
}
