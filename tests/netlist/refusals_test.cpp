// Compares refused netlists with their messages: refusals/STAGE/*.cfs and *.txt, each with one fault. STAGE is the
// folder of the room that finds the fault. PLACEDPAR_ACCEPT=1 writes the texts anew, to show the effect of a change.

#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace placedpar;

namespace {

std::vector<std::filesystem::path> refused_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(netlist_folder() + "/refusals"))
        if (entry.path().extension() == ".cfs")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Removes the folder, which differs between machines.
std::string without_folder(std::string text, const std::filesystem::path& file) {
    auto folder = file.parent_path().string() + "/";
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
        text.erase(at, folder.size());
    return text;
}

} // namespace

TEST_CASE("every refusal says what is wrong, where, and what would be right") {
    CHECK(refused_files().size() > 60);
    for (const auto& file : refused_files()) {
        CAPTURE(file.filename().string());
        const ParsedNetlist netlist(file);
        auto result = netlist.read(small_catalogue());
        CHECK_FALSE(result.network);
        CHECK(render(netlist.read(small_catalogue())) == render(result)); // a parsed netlist can be read repeatedly
        auto text = without_folder(render(result), file);
        auto expected = std::filesystem::path(file).replace_extension(".txt");
        if (std::getenv("PLACEDPAR_ACCEPT") != nullptr)
            std::ofstream(expected) << text;
        CHECK(text == read_text(expected));
    }
}
