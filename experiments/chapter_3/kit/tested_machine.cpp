#include "experiments/chapter_3/kit/tested_machine.hpp"

#include <limits>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr double pause_s = 2.5;

/// Returns settings with which the diagnosis never starts a search, because verdicts do not need a search. The gate,
/// which lets samples into a search, never opens.
DiagnosisSettings without_searches() {
    DiagnosisSettings settings;
    settings.gate.slope_psi_per_s = std::numeric_limits<double>::infinity();
    return settings;
}

ExcavatorParameters read_every(double period_s) {
    ExcavatorParameters parameters = excavator_parameters(Parameters::excavator());
    parameters.period_s = period_s;
    return parameters;
}

} // namespace

TestedMachine::TestedMachine(const RecordSource& source, AreasFrom from, std::uint64_t seed)
    : digger_(source, from, seed), diagnosis_("digger", read_every(source.period_s), without_searches(), seed) {
    diagnosis_.change({Configuration::a, digger_.links()});
}

void TestedMachine::move(const PlantFault& fault, double compliance_factor, std::uint64_t number) {
    const Record movement = digger_.movement(fault, compliance_factor, number);
    for (std::size_t i = 0; i < movement.size(); ++i)
        diagnosis_.take(digger_.sample(movement, i, next_s_));
    next_s_ += movement.time_s.back() + pause_s;
    // The next sample has the machine at rest again. The gap in time before this sample makes the diagnosis end an
    // unfinished movement and judge it.
    diagnosis_.take(digger_.sample(movement, 0, next_s_));
    next_s_ += pause_s;
}

} // namespace placedpar
