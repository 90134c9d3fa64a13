#pragma once

#include "explore/netlist_run.hpp"
#include "explore/optimise/machine_space.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study.hpp"
#include "gaprocs/merit.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

struct Trial {
    Merit merit;
    bool simulated = false; ///< false: the study's condition does not hold for the machine, or its netlist is refused
    std::string why = "";   ///< why the machine is infeasible: a refusal, how a run ended if it did not complete, or a
                            ///< missing measure
};

/// Returns a copy of the study that runs only these settings.
Study study_of(const Study&, const std::vector<Overrides>& all);

/// Runs machines (combinations of a netlist's settings) for a search, with every seed of the study. Keeps the runs in
/// the results, so that no run is made twice. The result of a machine depends neither on when the machine is tried nor
/// on other machines.
class MachineTrials {
public:
    /// REQUIRES: the arguments outlive this object; Study::search has a value.
    MachineTrials(const Study&, const MachineSpace&, StudyResults&, std::size_t workers, Interruption&);

    /// Makes the missing runs, and calls `show` from time to time with the number of runs made. Returns false if
    /// interrupted.
    bool try_out(std::span<const std::uint64_t> machines, const std::function<void(std::uint64_t runs)>& show);
    /// REQUIRES: the machine has been tried out.
    const Trial& of(std::uint64_t machine);
    /// Makes the missing runs with these settings, and returns their trial. Returns nothing if interrupted.
    std::optional<Trial> of(const Overrides& settings);

    /// Throws UserError if runs have completed, but no completed run has one of the measures to be minimised. The
    /// message lists the measures of a completed run.
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
