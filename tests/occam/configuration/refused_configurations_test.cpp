// Compares configurations that are refused with their messages: refusals/configuration/*.pgm and *.txt, each with one
// fault. PLACEDPAR_ACCEPT=1 writes the texts anew, to show the effect of a change.

#include "tests/occam/configuration/configured_text.hpp"
#include "tests/occam/language/read_text.hpp"
#include "tests/occam/network/network_text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

using namespace placedpar;

TEST_CASE("each configuration that is refused has its message") {
    const auto files = test::occam_files(test::occam_path("refusals/configuration"), ".pgm");
    CHECK(files.size() > 60);
    const Catalogue catalogue = test::occam_catalogue();
    for (const auto& file : files) {
        CAPTURE(file.filename().string());
        const ReadResult read = read_netlist(file, catalogue, {}, test::configuration_options());
        CHECK_FALSE(read.network);
        std::string messages = render(read);
        const std::string folder = file.parent_path().string();
        for (auto at = messages.find(folder); at != std::string::npos; at = messages.find(folder))
            messages.replace(at, folder.size() + (messages[at + folder.size()] == '/'), "");
        const auto expected = std::filesystem::path(file).replace_extension(".txt");
        if (std::getenv("PLACEDPAR_ACCEPT") != nullptr)
            std::ofstream(expected, std::ios::binary) << messages;
        CHECK(messages == test::whole_file(expected));
    }
}
