#include "app/experiment.hpp"

#include "runtime/fingerprint.hpp"

namespace placedpar {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{
        {"table-2-6", "steady flow of the boom over spool and pressure, and what errors in them do", replay_table_2_6},
        {"figure-2-3", "the bulk modulus of oil with air in it, over pressure", replay_figure_2_3},
        {"figures-2-8-2-9", "a P-D loop's step response, and what a greater compliance does to it",
         replay_figures_2_8_2_9},
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
