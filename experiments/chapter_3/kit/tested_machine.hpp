#pragma once

#include "experiments/chapter_3/kit/simulated_excavator.hpp"
#include "identification/on_line/diagnosis.hpp"

#include <vector>

namespace placedpar {

/// A digger that is watched on line, by a diagnosis that believes it to be the machine of excavator.csv.
class TestedMachine {
public:
    TestedMachine(const RecordSource& source, hydraulics::AreasFrom from, std::uint64_t seed);

    /// SimulatedExcavator::movement(), shown to the diagnosis, which has judged it when this returns.
    void move(const PlantFault& fault, double compliance_factor, std::uint64_t number);
    const identification::Diagnosis& diagnosis() const { return diagnosis_; }
    /// The alarms that hold.
    const std::vector<identification::Alarm>& alarms() const { return diagnosis_.alarms(); }

private:
    SimulatedExcavator digger_;
    identification::Diagnosis diagnosis_;
    double next_s_ = 0; ///< when the next movement begins
};

} // namespace placedpar
