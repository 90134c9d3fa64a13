#pragma once

#include "experiments/chapter_3/kit/simulated_excavator.hpp"
#include "identification/on_line/diagnosis.hpp"

#include <vector>

namespace placedpar {

/// A simulated excavator and its on-line diagnosis, which raises an alarm when it finds a fault. The diagnosis assumes
/// the parameters of `excavator.csv`.
class TestedMachine {
public:
    TestedMachine(const RecordSource& source, hydraulics::AreasFrom from, std::uint64_t seed);

    /// Passes a movement (SimulatedExcavator::movement()) and then a pause to the diagnosis. On return, the diagnosis
    /// has judged the movement.
    void move(const PlantFault& fault, double compliance_factor, std::uint64_t number);
    const identification::Diagnosis& diagnosis() const { return diagnosis_; }
    const std::vector<identification::Alarm>& alarms() const { return diagnosis_.alarms(); }

private:
    SimulatedExcavator digger_;
    identification::Diagnosis diagnosis_;
    double next_s_ = 0; ///< start of the next movement
};

} // namespace placedpar
