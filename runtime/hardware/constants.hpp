#pragma once

#include <string_view>
#include <vector>

namespace placedpar::hardware {

/// The origin of a constant.
enum class Provenance {
    published,  ///< from a databook, or from a published measurement
    workload,   ///< cost of the program itself, which the netlist states
    calibrated, ///< set so that the model reproduces one measured figure
    ours,       ///< our choice, because no source was found
    fitted      ///< fitted to several measured figures
};

const char* name_of(Provenance);

/// A constant of the model with its origin.
struct Constant {
    std::string_view group, name;
    double value;
    std::string_view unit;
    Provenance mark;
    std::string_view source; ///< the publication, the reason for our choice, or the measured figures of a fit
};

/// Returns every timing constant that a netlist does not state. The simulation uses the same constants. The constants
/// of a group are adjacent.
std::vector<Constant> constants();

} // namespace placedpar::hardware
