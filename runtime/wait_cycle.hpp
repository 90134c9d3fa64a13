#pragma once

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace placedpar {

/// Finds a cycle of processes of which each waits for the next, for the report of a deadlock. The search goes depth
/// first from each process to those for which it waits. `Awaited` is a function that returns the processes for which a
/// given process waits.
template <class Process, class Awaited>
class CycleSearch {
public:
    explicit CycleSearch(Awaited awaited) : awaited_(std::move(awaited)) {}

    /// Returns the first cycle that the search finds, starting from each of the `stuck` processes in turn; empty if
    /// there is none.
    std::vector<Process> find(const std::vector<Process>& stuck) {
        for (const Process& process : stuck)
            if (visit(process))
                return cycle_;
        return {};
    }

private:
    /// Returns whether the search from `start` finds a cycle. The search is not recursive, because its path can contain
    /// all processes, and the stack of a fiber is small.
    bool visit(const Process& start) {
        step_to(start);
        while (!way_.empty()) {
            Step& step = way_.back();
            if (step.next_partner == step.partners.size()) {
                place_on_way_[step.process] = been_there;
                way_.pop_back();
            } else if (step_to(step.partners[step.next_partner++])) {
                return true;
            }
        }
        return false;
    }

    /// Visits the process. Returns whether this closes a cycle.
    bool step_to(const Process& process) {
        const auto [place, is_new] = place_on_way_.try_emplace(process, way_.size());
        if (is_new)
            way_.push_back({process, awaited_(process), 0});
        else if (place->second != been_there)
            for (std::size_t i = place->second; i < way_.size(); ++i)
                cycle_.push_back(way_[i].process);
        return !cycle_.empty();
    }

    struct Step {
        Process process;
        std::vector<Process> partners;
        std::size_t next_partner;
    };
    static constexpr std::size_t been_there = static_cast<std::size_t>(-1);

    Awaited awaited_;
    std::vector<Step> way_;
    std::unordered_map<Process, std::size_t> place_on_way_; ///< never iterated over
    std::vector<Process> cycle_;
};

} // namespace placedpar
