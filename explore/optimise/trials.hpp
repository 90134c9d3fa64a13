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
    bool simulated = false; ///< false: there is no such machine, so it cost no run
    std::string why = "";   ///< it is infeasible: what the study or the netlist says, how a run ended, what it lacked
};

/// The study's runs of these settings alone.
Study study_of(const Study&, const std::vector<Overrides>& all);

/// Machines that are tried out: run with each seed of the study, and kept as a sweep keeps them, so that no run is made
/// twice. What comes of a machine does not depend on when it is tried, or beside which others.
class MachineTrials {
public:
    /// REQUIRES: all outlive it; the study has a search.
    MachineTrials(const Study&, const MachineSpace&, StudyResults&, std::size_t workers, Interruption&);

    /// Makes the runs that are missing, and tells `show` now and then how many have been. False when interrupted.
    bool try_out(std::span<const std::uint64_t> machines, const std::function<void(std::uint64_t runs)>& show);
    /// REQUIRES: it has been tried out.
    const Trial& of(std::uint64_t machine);
    /// Returns the trial of any settings, and makes its runs if they are missing; none when interrupted.
    std::optional<Trial> of(const Overrides& settings);

    /// Throws UserError, naming those that there are, where a measure that is to be minimised has been found of no
    /// machine yet, although some runs completed.
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
    std::vector<bool> found_;         ///< by cost
    std::optional<StudyFigures> any_; ///< of a run that completed
};

} // namespace placedpar
