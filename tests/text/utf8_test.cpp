#include "text/utf8.hpp"

#include "text/counted.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("the first character of a text is found, or invalid bytes") {
    auto first = [](std::string_view text) {
        return std::pair(first_character(text).code, first_character(text).bytes);
    };
    CHECK(first("ab") == std::pair(U'a', std::size_t{1}));
    CHECK(first("\xc3\xa4") == std::pair(U'\u00e4', std::size_t{2}));
    CHECK(first("\xe2\x80\x93x") == std::pair(U'\u2013', std::size_t{3}));
    CHECK(first("\xf0\x9f\x98\x80") == std::pair(U'\U0001f600', std::size_t{4}));
    for (const char* none : {"", "\x80", "\xc3", "\xc3z", "\xff", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                             "\xf8\x88\x80\x80\x80"}) {
        CAPTURE(none);
        CHECK(first_character(none).bytes == 0);
    }
}

TEST_CASE("bytes that a terminal would act on are escaped") {
    CHECK(escaped("a\tb\x1b\n\x7f\xc3\xa4\xff\xc2\x9b") == "a\tb\\x1b\\x0a\\x7f\xc3\xa4\\xff\\xc2\\x9b");
}

TEST_CASE("characters special to XML and HTML are escaped") {
    CHECK(as_markup("a < b > \"c\" & d\x1b\x7f") == "a &lt; b &gt; &quot;c&quot; &amp; d??");
    CHECK(as_markup("\xc3\xa4 \xdf") == "\xc3\xa4 \xc3\x9f"); // Latin-1
}

TEST_CASE("control characters of two bytes and invalid characters are replaced in XML, HTML and JSON") {
    CHECK(as_markup("\xc2\x9b\x9b\t\n\xef\xbf\xbe") == "?????");
    CHECK(as_json("{\"a\": \"\xc2\x9b\x7f\xff\xc3\xa4\"}\n") == "{\"a\": \"\\u009b\\u007f\xc3\xbf\xc3\xa4\"}\n");
}

TEST_CASE("the noun after a count of one is singular") {
    CHECK(counted(1, "link") == "1 link");
    CHECK(counted(0, "link") == "0 links");
    CHECK(counted(2, "process", "processes") == "2 processes");
    CHECK(counted(1, "process", "processes") == "1 process");
}
