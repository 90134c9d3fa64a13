#pragma once

#include "app/options/netlist_options.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// What the command line of `placedpar identify` may say. What stands for one way only is empty where it was not typed.
struct IdentifyOptions {
    std::string record, links, configuration = "a", way = "service", offset, areas, missing = "refuse", machine, json;
    std::uint64_t seed = 1;
    std::size_t bits = 10, population = 120, trials = 5, window = 10;
    double bias = 400;
    std::optional<std::size_t> elite;
    bool strict = false;

    // Of --way thesis
    std::string coding, netlist;
    std::vector<std::string> set;
    ReadOptionsTyped read; ///< of the netlist
    std::optional<std::size_t> samples;
    bool rising = false;
};

void declare_identify_options(Options& command, IdentifyOptions& options);

} // namespace placedpar
