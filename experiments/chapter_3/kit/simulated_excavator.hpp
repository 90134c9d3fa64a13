#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>
#include <cstdint>

namespace placedpar {

/// A simulated machine that an operator moves. Machines differ from `excavator.csv` by up to 10 % in inlet compliances
/// and load, and by up to 20 % in friction, damping and the drain side's compliance. Movements differ in how far, how
/// quickly and for how long the valve is opened, and by up to 5 % in the load. The thesis has no values for this
/// scatter; we chose these.
class SimulatedExcavator {
public:
    /// `from` says which readings of the valves the samples contain: spool, voltage or areas. Only a source with a
    /// servo-valve has both spool and voltage.
    SimulatedExcavator(const RecordSource& source, hydraulics::AreasFrom from, std::uint64_t seed);

    /// Returns the links that move, in configuration a.
    hydraulics::LinkSet links() const;
    double period_s() const { return source_.period_s; } ///< time between readings

    /// Returns a movement with this fault and `compliance_factor` times the boom's own compliance. The movement begins
    /// at rest. It ends at rest with a servo-valve; otherwise the record ends while the valve is open. `number`
    /// determines all random values of the movement.
    hydraulics::Record movement(const PlantFault& fault, double compliance_factor, std::uint64_t number) const;
    /// Returns the control system's readings at one instant of a movement, which began at the time `begun_s`.
    identification::ExcavatorSample sample(const hydraulics::Record& movement, std::size_t index, double begun_s) const;

private:
    RecordSource source_;
    hydraulics::AreasFrom from_;
    std::uint64_t seed_;
    hydraulics::Parameters parameters_;
};

} // namespace placedpar
