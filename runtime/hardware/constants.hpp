#pragma once

#include <string_view>
#include <vector>

namespace placedpar::hardware {

/// Where a constant comes from.
enum class Provenance {
    published,  ///< a databook, or a measurement that others have published
    workload,   ///< what a program itself costs; the netlist states it
    calibrated, ///< set so that one figure that was measured comes out
    ours,       ///< nothing was to be had: a choice that seems right
    fitted      ///< to several figures that were measured
};

const char* name_of(Provenance);

/// A constant of the model, for people who want to know where a time comes from.
struct Constant {
    std::string_view group, name;
    double value;
    std::string_view unit;
    Provenance mark;
    std::string_view source; ///< of what is published; what the others stand for, or were fitted to
};

/// Every constant that takes time on the machine and is not the netlist's to state, read from where the simulation
/// takes it. Those of a group are adjacent.
std::vector<Constant> constants();

} // namespace placedpar::hardware
