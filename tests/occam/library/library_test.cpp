#include "occam/library/library.hpp"

#include <doctest/doctest.h>

namespace placedpar::occam {

TEST_CASE("libraries are found by name with any extension, constants by theirs") {
    for (const std::string& name : library_names()) {
        std::optional<std::string> text = library_text(name);
        REQUIRE(text);
        CHECK(text->size() > 100);
        CHECK(text->find("-- ") == 0); // each begins by saying what it is
    }
    CHECK(library_text("hostio.lib") == library_text("hostio.tco"));
    CHECK(library_text("hostio.lib") == library_text("hostio"));
    CHECK(library_text("hostio.lib") != library_text("hostio.inc"));
    CHECK(library_text("hostio.inc")->find("PROTOCOL SP IS INT16::[]BYTE:") != std::string::npos);
    CHECK_FALSE(library_text("convert.inc"));
    CHECK_FALSE(library_text("nothing.lib"));
    CHECK_FALSE(library_text(""));
}

} // namespace placedpar::occam
