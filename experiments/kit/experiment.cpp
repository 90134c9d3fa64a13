#include "experiments/kit/experiment.hpp"

#include "runtime/fingerprint.hpp"

namespace placedpar {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{
        {"table-2-6", "steady flow of the boom over spool and pressure, and what errors in them do", replay_table_2_6},
        {"figure-2-3", "the bulk modulus of oil with air in it, over pressure", replay_figure_2_3},
        {"figures-2-8-2-9", "a P-D loop's step response, and what a greater compliance does to it",
         replay_figures_2_8_2_9},
        {"experiments-1-2", "the boom's compliance identified from the spool and from the servo-valve's voltage",
         replay_experiments_1_2},
        {"first-attempt", "the thesis's failed identification: an offset of the spool, flagged, calibrated and cured",
         replay_first_attempt},
        {"figure-3-8", "the identified compliance simulates the pressure of other motions", replay_figure_3_8},
        {"identification-study", "50 seeds at four levels of noise: how well the boom's compliance is identified",
         replay_identification_study},
        {"figures-3-9-to-3-11", "bucket and boom together: both compliances, and the states inside the valve",
         replay_figures_3_9_to_3_11},
        {"loss-of-excitation", "what becomes of the estimates when the motion is steady", replay_loss_of_excitation},
        {"faults", "compliance doubled, a leak, a drift of the servo-valve: what the identification shows",
         replay_faults},
        {"table-e1", "what a generation costs on one cluster with 0 to 3 slaves", replay_table_e1},
        {"table-e2", "the speedup of algorithms B, A, and A + B on the machine of Figure E.2", replay_table_e2},
    };
    return all;
}

bool Replay::within_tolerance() const {
    for (const Reading& reading : readings)
        if ((&reading == &readings.front() || reading.judged) && !placedpar::within_tolerance(reading))
            return false;
    return true;
}

std::uint64_t fingerprint_of(const std::vector<Reading>& readings) {
    Fingerprint fingerprint;
    for (const Reading& reading : readings)
        for (char character : print_reading(reading))
            fingerprint.mix(static_cast<unsigned char>(character));
    return fingerprint.value();
}

} // namespace placedpar
