#include "text/paint.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("nothing is coloured until the program says that its stream is") {
    CHECK(painted(Paint::error, "error:") == "error:");
    set_painted(PaintedStream::errors, true);
    CHECK(painted(Paint::error, "error:") == "\033[1;31merror:\033[0m");
    CHECK(painted(Paint::heading, "ports") == "ports"); // on the other stream
    set_painted(PaintedStream::errors, false);
    set_painted(PaintedStream::output, true);
    CHECK(painted(Paint::heading, "\nports\n") == "\n\033[1mports\033[0m\n"); // lines' ends stay outside
    CHECK(painted(Paint::success, "") == "");
    CHECK(painted(Paint::caret, "^") == "^");
    set_painted(PaintedStream::output, false);
    CHECK(painted(Paint::heading, "ports") == "ports");
}

TEST_CASE("what is printed keeps its lines, and no colours but its own") {
    const std::string hostile = "a\n\033[1mb\033[2J\xff\033";
    CHECK(escaped_but_paint(hostile) == "a\n\\x1b[1mb\\x1b[2J\\xff\\x1b");
    set_painted(PaintedStream::errors, true);
    CHECK(escaped_but_paint(painted(Paint::error, "error:") + " " + hostile.substr(9)) ==
          "\033[1;31merror:\033[0m 2J\\xff\\x1b");
    set_painted(PaintedStream::errors, false);
}
