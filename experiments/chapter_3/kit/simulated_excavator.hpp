#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>
#include <cstdint>

namespace placedpar {

/// A simulated machine that an operator moves. The sizes of all scatter are ours. Machines differ in compliances by up
/// to 10 %, in friction, damping and the drain side by 20 %, and in the load by 10 %. Movements differ in how far, how
/// quickly and for how long the valve is opened, and in the load by 5 %.
class SimulatedExcavator {
public:
    /// `from` says which readings of the valves the samples contain. Only a source with a servo-valve has both spool
    /// and servo.
    SimulatedExcavator(const RecordSource& source, hydraulics::AreasFrom from, std::uint64_t seed);

    /// Returns the links that move, in configuration a.
    hydraulics::LinkSet links() const;
    double period_s() const { return source_.period_s; } ///< time between readings

    /// Returns a movement with this fault and `compliance_factor` times the boom's own compliance. It goes from rest to
    /// rest, or to the end of the record if the plant cannot shut its valve. `number` determines all random values; no
    /// two movements are alike.
    hydraulics::Record movement(const PlantFault& fault, double compliance_factor, std::uint64_t number) const;
    /// Returns the readings of the control system at one instant of a movement that begins at `begun_s` of its clock.
    identification::ExcavatorSample sample(const hydraulics::Record& movement, std::size_t index, double begun_s) const;

private:
    RecordSource source_;
    hydraulics::AreasFrom from_;
    std::uint64_t seed_;
    hydraulics::Parameters parameters_;
};

} // namespace placedpar
