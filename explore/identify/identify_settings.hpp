#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// The settings of an identification, as `placedpar identify` takes them. An identification finds the compliances of an
/// excavator's hydraulics in a record of measurements. There are several ways to do this. A setting that only one way
/// uses is empty if it was not given.
struct IdentifySettings {
    std::string links, configuration, way, offset, areas, missing = "refuse", machine;
    std::vector<std::string> columns; ///< names of columns, such as "boom.inlet_pressure=P_boom_in"
    std::string columns_from;         ///< a file with such names, one on each line
    std::uint64_t seed = 1;
    std::optional<std::size_t> bits, population, trials, window, elite; ///< empty: the way's default
    double bias = 400;
    bool has_default_way = false; ///< set by settle_way(): no way was given

    static constexpr std::size_t least_bits = 6, most_bits = 52, most_window = 1024, a_million = 1'000'000;

    // The way "service" does not use these members.
    std::string coding, side = "inlet";
    std::optional<std::size_t> samples;
    bool rising = false;
};

} // namespace placedpar
