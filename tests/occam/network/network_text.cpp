#include "tests/occam/network/network_text.hpp"

#include "iserver/terminal.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/machine.hpp"
#include "occam/network/file_kinds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <unistd.h>

#include <fstream>
#include <memory>

namespace placedpar::test {

namespace {

std::filesystem::path new_folder() {
    static int number = 0;
    return std::filesystem::temp_directory_path() / fmt::format("placedpar-occam-{}-{}", ::getpid(), ++number);
}

} // namespace

FilesOfNetwork::FilesOfNetwork(const std::map<std::string, std::string>& files) : folder_(new_folder()) {
    std::filesystem::create_directories(folder_);
    for (const auto& [name, text] : files)
        write(name, text);
}

FilesOfNetwork::~FilesOfNetwork() { std::filesystem::remove_all(folder_); }

void FilesOfNetwork::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string FilesOfNetwork::without_folder(std::string text) const {
    const std::string folder = folder_.string() + "/";
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
        text.erase(at, folder.size());
    return text;
}

Catalogue occam_catalogue() {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    catalogue.make_from_files(occam::make_file_kinds());
    return catalogue;
}

RunOfNetwork run_network(const std::filesystem::path& netlist, const Catalogue& catalogue, const Overrides& overrides,
                         std::optional<std::uint64_t> shuffle) {
    ReadResult read = read_netlist(netlist, catalogue, overrides);
    INFO(render(read));
    REQUIRE(read.network);
    RunOfNetwork run;
    read.network->host.terminal = [&run] {
        return std::make_shared<iserver::ScriptedTerminal>(
            "", [&run](std::string_view text) { run.screen += std::string(text); });
    };
    Machine machine(*read.network, catalogue, 1);
    if (shuffle)
        machine.shuffle(*shuffle);
    run.report = machine.run();
    return run;
}

} // namespace placedpar::test
