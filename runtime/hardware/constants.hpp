#pragma once

#include <string_view>
#include <vector>

namespace placedpar::hardware {

/// The origin of a constant.
enum class Provenance {
    published,  ///< from a databook or a published measurement
    workload,   ///< cost of the simulated program, which the netlist states
    calibrated, ///< set so that the simulation reproduces one measured figure
    ours,       ///< our choice, because no source was found
    fitted      ///< fitted to several measured figures
};

const char* name_of(Provenance);

/// A constant of the simulated machine, with its origin. A command of the program prints these constants.
struct Constant {
    std::string_view group, name;
    double value;
    std::string_view unit;
    Provenance mark;
    std::string_view source; ///< the publication, the reason for our choice, or the figures to which the constant was
                             ///< fitted
};

/// Returns every timing constant that a netlist does not have to state, as the simulation uses it. The constants of a
/// group are adjacent.
std::vector<Constant> constants();

} // namespace placedpar::hardware
