// Compares programs that the check refuses with their messages: refusals/check/*.occ and *.txt.
// PLACEDPAR_ACCEPT=1 writes the texts anew, to show the effect of a change.

#include "tests/occam/check/check_text.hpp"
#include "tests/occam/language/read_text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

using namespace placedpar;

TEST_CASE("each program that the check refuses has its message") {
    const auto files = test::occam_files(test::occam_path("refusals/check"), ".occ");
    CHECK(files.size() > 50);
    for (const auto& file : files) {
        CAPTURE(file.filename().string());
        const test::CheckedText checked = test::check_text(test::whole_file(file), file.filename().string());
        CHECK(checked.failed);
        const auto expected = std::filesystem::path(file).replace_extension(".txt");
        if (std::getenv("PLACEDPAR_ACCEPT") != nullptr)
            std::ofstream(expected, std::ios::binary) << checked.messages;
        CHECK(checked.messages == test::whole_file(expected));
    }
}
