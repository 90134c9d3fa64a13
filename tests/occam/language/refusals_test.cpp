// Compares refused programs with their messages: refusals/language/*.occ and *.txt, each with one fault.
// PLACEDPAR_ACCEPT=1 writes the texts anew, to show the effect of a change.

#include "tests/occam/language/read_text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

using namespace placedpar;

TEST_CASE("each refused program of occam has its message") {
    const auto files = test::occam_files(test::occam_path("refusals/language"), ".occ");
    CHECK(files.size() > 60);
    for (const auto& file : files) {
        CAPTURE(file.filename().string());
        const auto read = test::read_text(test::whole_file(file), file.filename().string());
        CHECK(read.failed != file.filename().string().starts_with("warning-"));
        const auto expected = std::filesystem::path(file).replace_extension(".txt");
        if (std::getenv("PLACEDPAR_ACCEPT") != nullptr)
            std::ofstream(expected, std::ios::binary) << read.messages;
        CHECK(read.messages == test::whole_file(expected));
    }
}
