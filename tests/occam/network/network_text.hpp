#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/read.hpp"
#include "netlist/run_report.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace placedpar::test {

/// A folder with files, which exists as long as the object.
class FilesOfNetwork {
public:
    explicit FilesOfNetwork(const std::map<std::string, std::string>& files);
    ~FilesOfNetwork();
    FilesOfNetwork(const FilesOfNetwork&) = delete;
    FilesOfNetwork& operator=(const FilesOfNetwork&) = delete;
    void write(const std::string& name, const std::string& text) const;
    std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    /// Returns the text without the folder, which differs between runs.
    std::string without_folder(std::string text) const;

private:
    std::filesystem::path folder_;
};

/// Returns a catalogue with the csp kinds and with kinds of files in occam.
Catalogue occam_catalogue();

/// The text that a network printed, and the report of its run.
struct RunOfNetwork {
    std::string screen;
    RunReport report;
};

/// Runs a netlist, with ready processes in a random order if `shuffle` is given. REQUIRES: it can be read.
RunOfNetwork run_network(const std::filesystem::path& netlist, const Catalogue&, const Overrides& = {},
                         const ReadOptions& = {}, std::optional<std::uint64_t> shuffle = {});

} // namespace placedpar::test
