#pragma once

#include "app/options/netlist_options.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// The options of `placedpar identify`. An option that only one --way uses is empty if it was not typed.
struct IdentifyOptions {
    std::vector<std::string> records; ///< all that were typed
    std::string record;               ///< the one that is being read
    std::vector<std::string> columns;
    std::string columns_from, trend;
    std::string links, configuration, way, offset, areas, missing = "refuse", machine, json;
    std::uint64_t seed = 1;
    std::optional<std::size_t> bits, population, trials, window, elite; ///< empty: the default of the way
    double bias = 400;
    bool strict = false;

    // --way service does not use these members.
    std::string coding, netlist, side = "inlet";
    std::vector<std::string> set;
    ReadOptionsTyped read; ///< for the netlist
    std::optional<std::size_t> samples;
    bool rising = false;
};

void declare_identify_options(Options& command, IdentifyOptions& options);

} // namespace placedpar
