#pragma once

#include "explore/load.hpp"
#include "picture/plot.hpp"
#include "report/comparison.hpp"
#include "runtime/hardware/constants.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

class Interruption; // explore/netlist_run.hpp
class StudyResults; // explore/study/results.hpp

/// A picture that is no plot, and the name of its file, without .svg.
struct NamedDrawing {
    std::string name, svg;
};

/// An experiment of the thesis, run.
struct Replay {
    std::vector<Comparison> comparisons; ///< judged by the first of them, and by the others that are `judged`
    std::string constants = {};          ///< for people: which were published, stated as workload, calibrated
    std::vector<hardware::Constant> constant_table = {}; ///< one by one
    std::uint64_t fingerprint = 0;
    std::vector<NamedPlot> plots = {};       ///< --plots draws them,
    std::vector<NamedDrawing> drawings = {}; ///< and writes these

    bool within_tolerance() const { return are_within_tolerance(comparisons); }
};

/// Of an experiment that runs no processes. The fingerprint is of its tables as printed, so that it does not depend on
/// the last bits.
Replay replay_of(std::vector<Comparison> comparisons, std::vector<NamedPlot> plots);

/// What an experiment is run with.
struct ReplayContext {
    std::filesystem::path examples;                   ///< the folder of the netlists
    std::uint64_t seed;                               ///< of every random stream
    std::function<void(const std::string&)> progress; ///< told what is being run; it may throw to end the experiment
    WarningSink warn;                                 ///< told the warnings of netlists
    Interruption& interruption;                       ///< ends the runs of netlists
    StudyResults& results;                            ///< what a study has found before, and finds
    std::size_t seeds = 0;                            ///< over which a study is run: see kit/seed_runs.hpp
};

/// What the file of an experiment says about it: see experiments/README.md.
struct Experiment {
    std::string_view name, about;
    std::string_view chapter; ///< of the thesis, or its appendix, or "machine": the experiments come in this order,
    int number;               ///< and those of a chapter in this one
    Replay (*run)(const ReplayContext&);
    std::size_t seeds = 0; ///< of a study by kit/seed_runs.hpp; 0: it is none
};

/// Every experiment: one of each file in the folders chapter_*, appendix_* and machine, by chapter and number.
const std::vector<Experiment>& experiments();

/// By chapter, appendices and the machine last, and number.
std::vector<Experiment> in_order(std::vector<Experiment>);

} // namespace placedpar
