#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>
#include <cstdint>

namespace placedpar {

/// A simulated excavator that an operator moves, for tests of the diagnosis. The parameters of a machine differ from
/// `excavator.csv` at random: inlet compliances and load by up to 10 %, friction, damping and the drain side's
/// compliance by up to 20 %. Movements differ in how far, how quickly and for how long the valve is opened, and by up
/// to 5 % in the load. The thesis states no such variation; these percentages were chosen here.
class SimulatedExcavator {
public:
    /// `from` says which readings of the valves the samples contain: spool, voltage or areas. The voltage is available
    /// only if the source has a servo-valve. The scenario for two links has only areas; the other scenarios have no
    /// areas. Throws std::invalid_argument if the readings are not available.
    SimulatedExcavator(const RecordSource& source, hydraulics::AreasFrom from, std::uint64_t seed);

    /// Returns the links that move.
    hydraulics::LinkSet links() const;
    double period_s() const { return source_.period_s; } ///< time between readings

    /// Returns the record of a movement with this fault and `compliance_factor` times the boom's own compliance. The
    /// movement begins at rest. With a servo-valve the movement also ends at rest; otherwise the record ends while the
    /// valve is open. `number` determines all random values of the movement.
    hydraulics::Record movement(const PlantFault& fault, double compliance_factor, std::uint64_t number) const;
    /// Returns the control system's readings at the instant `index` of a movement that began at the time `begun_s`.
    identification::ExcavatorSample sample(const hydraulics::Record& movement, std::size_t index, double begun_s) const;

private:
    RecordSource source_;
    hydraulics::AreasFrom from_;
    std::uint64_t seed_;
    hydraulics::Parameters parameters_;
};

} // namespace placedpar
