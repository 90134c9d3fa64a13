#include "text/paint.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

std::string printed(Paint paint, const char* text) { return escaped_but_paint(painted(paint, text)); }

} // namespace

TEST_CASE("no colours are printed until the program enables them") {
    CHECK(printed(Paint::error, "error:") == "error:");
    set_painted(PaintedStream::errors, true);
    CHECK(printed(Paint::error, "error:") == "\033[1;31merror:\033[0m");
    CHECK(printed(Paint::heading, "ports") == "ports"); // headings belong to the other stream
    set_painted(PaintedStream::errors, false);
    set_painted(PaintedStream::output, true);
    CHECK(printed(Paint::heading, "\nports\n") == "\n\033[1mports\033[0m\n"); // newlines stay outside the colour codes
    CHECK(printed(Paint::success, "") == "");
    CHECK(printed(Paint::caret, "^") == "^");
    set_painted(PaintedStream::output, false);
    CHECK(printed(Paint::heading, "ports") == "ports");
}

TEST_CASE("printed text keeps its lines, and colour codes from outside are escaped") {
    const std::string hostile = "a\n\033[1mb\033[1;31mc\033[0m\033[2J\xff\033",
                      shown = "a\n\\x1b[1mb\\x1b[1;31mc\\x1b[0m\\x1b[2J\\xff\\x1b";
    CHECK(escaped_but_paint(hostile) == shown);
    set_painted(PaintedStream::errors, true);
    CHECK(escaped_but_paint(hostile + painted(Paint::error, hostile) + "\033") ==
          shown + "\033[1;31m" + shown + "\033[0m\\x1b");
    set_painted(PaintedStream::errors, false);
}

TEST_CASE("removing colours leaves all other text") {
    set_painted(PaintedStream::errors, true);
    CHECK(unpainted("mm " + painted(Paint::place, "a:1:2:") + " " + painted(Paint::error, "m\033[1m\n") + "m") ==
          "mm a:1:2: m\033[1m\nm");
    set_painted(PaintedStream::errors, false);
    CHECK(unpainted("a\033[1m") == "a\033[1m");
}
