#include "iserver/terminal.hpp"

#include "text/utf8.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace placedpar;
using iserver::ScriptedTerminal;
using iserver::VisibleText;

namespace {

std::string visible(std::string_view text) {
    VisibleText screen;
    std::string shown = screen.next(text);
    return shown + screen.end();
}

} // namespace

TEST_CASE("text, cursor movements and colours pass") {
    const std::string text = "one\r\ntwo\t\b\a \xc3\xa9\xe2\x82\xac \x1b[2J\x1b[10;20Hx\x1b[K";
    CHECK(visible(text) == text);
    CHECK(visible("\x1b[1;31mred") == "\x1b[1;31mred\x1b[0m");
}

TEST_CASE("other control characters and bytes become visible") {
    CHECK(visible(std::string("\0\x01\x0c\x7f", 4)) == "^@^A^L^?");
    CHECK(visible("\x9b"
                  "2J\xff\xc2\x9b") == "\\x9b2J\\xff\\xc2\\x9b");
    CHECK(visible("\xc0\x8a") == "\\xc0\\x8a"); // a newline in an overlong form
}

TEST_CASE("sequences that answer, change a title or set modes become visible") {
    CHECK(visible("\x1b]0;title\a") == "^[]0;title\a");
    CHECK(visible("\x1b[6n\x1b[c") == "^[[6n^[[c");
    CHECK(visible("\x1b[?1049h\x1b[?5K\x1b[>4;2m") == "^[[?1049h^[[?5K^[[>4;2m");
    CHECK(visible("\x1b"
                  "c\x1bP0\x1b\\") == "^[c^[P0^[\\");
    CHECK(visible("\x1b[1\x1b[2J") == "^[[1\x1b[2J");
    CHECK(visible("\x1b[" + std::string(40, '1') + "m") == "^[[" + std::string(40, '1') + "m");
}

TEST_CASE("output means the same wherever it is split") {
    const std::string text = "a\x1b[1;5H\xe2\x82\xac\x1b[31mb\x1b[0m\x1b]0;x\a\x1b[6n\xe2\x82z\x9b\x1b\x1b[Kc";
    const std::string whole = visible(text);
    for (std::size_t first = 0; first <= text.size(); ++first)
        for (std::size_t second = first; second <= text.size(); ++second) {
            VisibleText screen;
            std::string shown = screen.next(text.substr(0, first));
            shown += screen.next(text.substr(first, second - first));
            shown += screen.next(text.substr(second));
            REQUIRE(shown + screen.end() == whole);
        }
}

TEST_CASE("what is incomplete when a program ends becomes visible") {
    CHECK(visible("x\x1b[3") == "x^[[3");
    CHECK(visible("x\xe2\x82") == "x\\xe2\\x82");
}

TEST_CASE("keys and lines are taken from one text") {
    std::string screen;
    ScriptedTerminal terminal("ab\ncd", [&](std::string_view text) { screen += text; });
    CHECK(terminal.pressed_key() == 'a');
    CHECK(terminal.line() == "b\n");
    CHECK_FALSE(terminal.at_end());
    CHECK(terminal.line() == "cd");
    CHECK(terminal.at_end());
    CHECK(terminal.line() == "");
    CHECK_FALSE(terminal.wait_for_key());
}
