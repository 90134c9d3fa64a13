#pragma once

#include "explore/netlist_run.hpp"
#include "explore/optimise/machine_space.hpp"
#include "explore/optimise/merit.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The result of trying a machine.
struct Trial {
    Merit merit;
    bool simulated = false; ///< false: the netlist or the study's condition refuses the machine
    std::string why = "";   ///< reason if the machine is infeasible: a refusal, the end of a run, or a missing measure
};

/// Returns the study with only these settings to run.
Study study_of(const Study&, const std::vector<Overrides>& all);

/// Tries machines: runs each with every seed of the study, and keeps the runs as a sweep does, so that no run is made
/// twice. The result of a machine does not depend on when it is tried, or on other machines.
class MachineTrials {
public:
    /// REQUIRES: the arguments outlive this object; the study has a search.
    MachineTrials(const Study&, const MachineSpace&, StudyResults&, std::size_t workers, Interruption&);

    /// Makes the missing runs, and calls `show` from time to time with the number of runs made. Returns false if
    /// interrupted.
    bool try_out(std::span<const std::uint64_t> machines, const std::function<void(std::uint64_t runs)>& show);
    /// REQUIRES: the machine has been tried out.
    const Trial& of(std::uint64_t machine);
    /// Returns the trial of any settings, and makes its runs if they are missing; returns nothing if interrupted.
    std::optional<Trial> of(const Overrides& settings);

    /// Throws UserError if runs have completed but no run had one of the measures to be minimised. The message lists
    /// the measures that the runs had.
    void require_measures() const;

private:
    bool make_runs(const std::vector<Overrides>& settings, const std::function<void(std::uint64_t)>& show);
    Trial trial_of(const Overrides& settings);
    void add_figures(Trial&, const StudyFigures&);

    const Study& study_;
    const MachineSpace& space_;
    StudyResults& results_;
    std::size_t workers_;
    Interruption& interruption_;
    std::vector<StudyMeasure> costs_;
    std::map<std::uint64_t, Trial> trials_;
    std::vector<bool> found_;         ///< for each cost: whether some run had this measure
    std::optional<StudyFigures> any_; ///< figures of some completed run
};

} // namespace placedpar
