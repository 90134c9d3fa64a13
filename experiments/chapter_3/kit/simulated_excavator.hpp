#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>
#include <cstdint>

namespace placedpar {

/// A simulated machine of its own, that an operator moves. All scatter is ours. From machine to machine: compliances by
/// up to 10 %, friction, damping and the drain side by 20 %, the load by 10 %. From movement to movement: how far the
/// valve is opened, how quickly and for how long, and the load by 5 %.
class SimulatedExcavator {
public:
    /// `from`: what is read of the valves. Only a source with a servo-valve has both spool and servo.
    SimulatedExcavator(const RecordSource& source, hydraulics::AreasFrom from, std::uint64_t seed);

    /// That move, in configuration a.
    hydraulics::LinkSet links() const;
    double period_s() const { return source_.period_s; } ///< between readings

    /// A movement with this fault and so many times the boom's own compliance, from rest: to rest, or to the end of
    /// the record where the plant cannot shut its valve. Its number decides all of it; no two are alike.
    hydraulics::Record movement(const PlantFault& fault, double compliance_factor, std::uint64_t number) const;
    /// What the control system reads at one instant of a movement that begins at `begun_s` by its clock.
    identification::ExcavatorSample sample(const hydraulics::Record& movement, std::size_t index, double begun_s) const;

private:
    RecordSource source_;
    hydraulics::AreasFrom from_;
    std::uint64_t seed_;
    hydraulics::Parameters parameters_;
};

} // namespace placedpar
