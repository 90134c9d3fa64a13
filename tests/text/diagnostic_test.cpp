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

TEST_CASE("a diagnostic is printed as compilers do, with hint and notes") {
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

TEST_CASE("a diagnostic may concern a whole file or no file") {
    CHECK(render(error({file(""), 0, 0})) == "a.txt: error: this is wrong\n");
    CHECK(render(error({})) == "error: this is wrong\n");
    CHECK(render(warning_at(3, 4, "this is odd")) == "warning: this is odd\n");
    CHECK(render(std::vector{error_at(0, 0, "one"), error_at(0, 0, "two")}) == "error: one\nerror: two\n");
}

TEST_CASE("the caret counts characters, and control characters are escaped") {
    CHECK(render(error({file("\xc3\xa4\xc3\xb6 @"), 1, 6})) == "a.txt:1:6: error: this is wrong\n"
                                                               "    \xc3\xa4\xc3\xb6 @\n"
                                                               "       ^\n");
    CHECK(render(error({file("\x1b[2J @"), 1, 6})) == "a.txt:1:6: error: this is wrong\n"
                                                      "    \\x1b[2J @\n"
                                                      "            ^\n");
}

TEST_CASE("a long line is shown around the caret") {
    std::string text = render(error({file(std::string(300, 'x') + "@" + std::string(300, 'x')), 1, 301}));
    std::size_t line = text.find("    ...x"), caret_line = text.find('\n', line) + 1;
    REQUIRE(line != std::string::npos);
    CHECK(text.substr(line, caret_line - line).ends_with("x...\n"));
    CHECK(text.find('@') - line == text.find('^') - caret_line);
    CHECK(text.find('^') - caret_line < 100);
}

TEST_CASE("control characters of a message are escaped") {
    auto diagnostic = error({file("a"), 1, 1});
    diagnostic.message = "there is no \"\x1b[31m\nx\"";
    diagnostic.hint = "say \x7f";
    diagnostic.others = {{"\xc2\x9b", {}}};
    CHECK(render(diagnostic) == "a.txt:1:1: error: there is no \"\\x1b[31m\\x0ax\"\n"
                                "    a\n"
                                "    ^\n"
                                "hint: say \\x7f\n"
                                "note: \\xc2\\x9b\n");
}

TEST_CASE("a reporter keeps one error for each place, at most twenty, and counts the rest") {
    Reporter reporter;
    auto source = file("a");
    reporter.warning({source, 1, 1}, "odd");
    CHECK_FALSE(reporter.failed());
    reporter.error({source, 1, 1}, "wrong");
    reporter.error({source, 1, 1}, "wrong again");
    CHECK(reporter.failed());
    for (std::size_t line = 2; line < 100; ++line)
        reporter.error({source, line, 1}, "wrong");
    CHECK(reporter.not_shown() == "... 79 more errors not shown\n");
    auto fill = [&] {
        for (std::size_t line = 100; line < 5000; ++line)
            reporter.error({source, line, 1}, "wrong");
    };
    CHECK_THROWS_AS(fill(), GiveUp);
    auto diagnostics = reporter.take();
    CHECK(diagnostics.size() == 1 + most_errors);
    CHECK(diagnostics[1].message == "wrong");
    CHECK(has_errors(diagnostics));
}

TEST_CASE("a diagnostic in an included file names each include on the way once") {
    Reporter reporter;
    auto outer = file("outer"), inner = file("inner");
    Location main{file("main"), 1, 1};
    reporter.add_included(outer, main);
    reporter.add_included(inner, {outer, 1, 1});
    reporter.error({inner, 1, 2}, "wrong");
    reporter.error(main, "wrong");
    auto diagnostics = reporter.take();
    REQUIRE(diagnostics[0].others.size() == 2);
    CHECK(diagnostics[0].others[0].location == Location{outer, 1, 1});
    CHECK(diagnostics[0].others[1].location == main);
    CHECK(diagnostics[1].others.empty());
}

TEST_CASE("repeated errors at one place end the reading") {
    Reporter reporter;
    auto repeat = [&, source = file("a")] {
        for (int i = 0; i < 1000; ++i)
            reporter.error({source, 1, 1}, "wrong");
    };
    CHECK_THROWS_AS(repeat(), GiveUp);
    CHECK(reporter.take().size() == 1);
}
