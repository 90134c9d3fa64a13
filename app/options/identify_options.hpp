#pragma once

#include "app/options/netlist_options.hpp"
#include "explore/identify/identify_settings.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// The options of `placedpar identify`.
struct IdentifyOptions : IdentifySettings {
    std::vector<std::string> records; ///< all records of the command line
    std::string record;               ///< the record that is being read
    std::string trend, json;
    bool strict = false;
    std::string netlist; ///< `netlist`, `set` and `read` are used only with --way thesis
    std::vector<std::string> set;
    ReadOptionsTyped read; ///< options for reading the netlist
};

void declare_identify_options(Options& command, IdentifyOptions& options);

} // namespace placedpar
