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
