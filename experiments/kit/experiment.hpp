#pragma once

#include "experiments/kit/reading.hpp"
#include "workbench/plot.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// An experiment of the thesis, run. The first reading is the default one; it is judged by that, and by those others
/// that say so.
struct Replay {
    std::vector<Reading> readings;
    std::string constants; ///< for people: which were published, stated as workload, calibrated
    std::uint64_t fingerprint = 0;
    std::vector<NamedPlot> plots = {}; ///< --plots draws them

    bool within_tolerance() const;
};

/// For an experiment that runs no processes: of its tables as printed, so that it does not depend on the last bits.
std::uint64_t fingerprint_of(const std::vector<Reading>&);

struct ReplayContext {
    std::filesystem::path examples;
    std::uint64_t seed;
    std::function<void(const std::string&)> progress; ///< what is being run
};

struct Experiment {
    std::string name;
    std::string about;
    std::function<Replay(const ReplayContext&)> run;
};

const std::vector<Experiment>& experiments();

Replay replay_experiments_1_2(const ReplayContext&);
Replay replay_faults(const ReplayContext&);
Replay replay_figure_2_3(const ReplayContext&);
Replay replay_figure_3_8(const ReplayContext&);
Replay replay_figures_2_8_2_9(const ReplayContext&);
Replay replay_figures_3_9_to_3_11(const ReplayContext&);
Replay replay_first_attempt(const ReplayContext&);
Replay replay_identification_study(const ReplayContext&);
Replay replay_loss_of_excitation(const ReplayContext&);
Replay replay_table_2_6(const ReplayContext&);
Replay replay_table_e1(const ReplayContext&);
Replay replay_table_e2(const ReplayContext&);

} // namespace placedpar
