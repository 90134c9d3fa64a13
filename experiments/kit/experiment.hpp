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

/// A picture other than a plot, and the name of its file without .svg.
struct NamedDrawing {
    std::string name, svg;
};

/// The results of an experiment of the thesis.
struct Replay {
    /// The first table and every `judged` table decide whether the experiment succeeds.
    std::vector<Comparison> comparisons;
    /// Text that says for each constant whether it was published, stated by the netlist, or calibrated.
    std::string constants = {};
    std::vector<hardware::Constant> constant_table = {}; ///< the machine's constants as a list
    std::uint64_t fingerprint = 0;
    std::vector<NamedPlot> plots = {};       ///< plots that the option --plots draws
    std::vector<NamedDrawing> drawings = {}; ///< other pictures that --plots writes

    bool within_tolerance() const { return are_within_tolerance(comparisons); }
};

/// Returns the result of an experiment that runs no netlist. The fingerprint is computed from the tables as printed, so
/// it does not depend on the last bits of the figures.
Replay replay_of(std::vector<Comparison> comparisons, std::vector<NamedPlot> plots);

struct ReplayContext {
    std::filesystem::path examples;                   ///< the folder of the netlists
    std::uint64_t seed;                               ///< seed of every random stream
    std::function<void(const std::string&)> progress; ///< called with the progress as text; may throw an exception to
                                                      ///< end the experiment
    WarningSink warn;                                 ///< called with the warnings of netlists
    Interruption& interruption;                       ///< when requested, ends the runs of netlists
    StudyResults& results; ///< results of earlier runs, which are not repeated; new results are added
    std::size_t seeds = 0; ///< number of seeds of a study: see kit/seed_runs.hpp
    bool printed = false;  ///< whether to judge by the figures that the thesis prints, even where other figures are
                           ///< expected
};

/// An experiment, as its source file describes it: see experiments/README.md.
struct Experiment {
    std::string_view name, about;
    std::string_view chapter; ///< a chapter or appendix of the thesis, or "machine"
    int number;               ///< order within the chapter
    Replay (*run)(const ReplayContext&);
    std::size_t seeds = 0;    ///< default number of seeds of a study (kit/seed_runs.hpp); 0: the experiment is not a
                              ///< study
    bool has_printed = false; ///< whether ReplayContext::printed has an effect
};

/// Returns every experiment, as sorted by in_order(). Each file in the folders chapter_*, appendix_* and machine
/// defines one experiment.
const std::vector<Experiment>& experiments();

/// Sorts by chapter, then by number. Appendices come after the chapters, and "machine" comes last.
std::vector<Experiment> in_order(std::vector<Experiment>);

} // namespace placedpar
