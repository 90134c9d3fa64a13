// One small netlist for each thing that is refused, and beside it what is printed: refusals/STAGE/*.cfs and *.txt, the
// stage being the folder of the room that finds the fault. To see what a change does, set PLACEDPAR_ACCEPT=1: the texts
// are then written anew.

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

/// Without the folder, which is another on every machine.
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
        CHECK(render(netlist.read(small_catalogue())) == render(result)); // however many networks are wanted
        auto text = without_folder(render(result), file);
        auto expected = std::filesystem::path(file).replace_extension(".txt");
        if (std::getenv("PLACEDPAR_ACCEPT") != nullptr)
            std::ofstream(expected) << text;
        CHECK(text == read_text(expected));
    }
}
