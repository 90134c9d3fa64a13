#pragma once

#include <string_view>
#include <vector>

namespace placedpar::hardware {

/// Where a constant comes from.
enum class Provenance {
    published,  ///< a databook, or a measurement that others have published
    workload,   ///< what a program itself costs; the netlist states it
    calibrated, ///< set so that one measured figure is reproduced
    ours,       ///< our choice, since no source was found
    fitted      ///< fitted to several measured figures
};

const char* name_of(Provenance);

/// A constant of the model, with its origin.
struct Constant {
    std::string_view group, name;
    double value;
    std::string_view unit;
    Provenance mark;
    std::string_view source; ///< the publication; otherwise the meaning of the choice, or the figures that it was
                             ///< fitted to
};

/// Returns every timing constant that a netlist does not state, read from where the simulation uses it. Constants of
/// one group are adjacent.
std::vector<Constant> constants();

} // namespace placedpar::hardware
