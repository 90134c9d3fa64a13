#pragma once

#include "app/options/netlist_options.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace placedpar {

/// What the command line of `placedpar identify` may say.
struct IdentifyOptions {
    std::string record, links = "boom", configuration = "a", way = "thesis", offset = "auto", areas, coding, machine,
                        netlist, json;
    std::vector<std::string> set;
    ReadOptionsTyped read; ///< of the netlist
    std::uint64_t seed = 1;
    std::size_t bits = 10, population = 120, trials = 5, window = 10, samples = 20;
    double bias = 400;
    std::optional<std::size_t> elite;
    bool rising = false, strict = false;
};

void declare_identify_options(CLI::App& command, IdentifyOptions& options);

} // namespace placedpar
