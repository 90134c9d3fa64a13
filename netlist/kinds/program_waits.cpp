#include "netlist/kinds/program_waits.hpp"

#include <cstddef>
#include <map>
#include <set>

namespace placedpar {

namespace {

/// Finds which process waits for which. A process is named by its number.
class ProgramWaitGraph {
public:
    explicit ProgramWaitGraph(const std::vector<ProgramWait>& waits) : waits_(waits) {
        for (std::size_t i = 0; i < waits.size(); ++i)
            for (const ProgramEnd& end : waits[i].ahead)
                comes_to_[end].push_back(i);
    }

    /// Returns the processes whose code would use this end of a channel, other than the one that waits for it.
    std::vector<std::size_t> partners(const ProgramEnd& end, std::size_t waiting) const {
        const auto found = comes_to_.find(end);
        std::vector<std::size_t> result = found == comes_to_.end() ? std::vector<std::size_t>{} : found->second;
        std::erase(result, waiting);
        return result;
    }

    /// Follows waits, depth first, until they return to a process on the way. Returns the circle; empty if there is
    /// none.
    std::vector<std::size_t> cycle() {
        for (std::size_t i = 0; i < waits_.size(); ++i)
            if (step_to(i); follow())
                return cycle_;
        return {};
    }

private:
    struct WaitStep {
        std::size_t process;
        std::vector<std::size_t> partners;
    };

    bool follow() {
        while (!way_.empty() && cycle_.empty()) {
            if (way_.back().partners.empty()) {
                on_way_.erase(way_.back().process);
                way_.pop_back();
                continue;
            }
            const std::size_t next = way_.back().partners.back();
            way_.back().partners.pop_back();
            step_to(next);
        }
        return !cycle_.empty();
    }

    void step_to(std::size_t process) {
        if (const auto place = on_way_.find(process); place != on_way_.end())
            for (std::size_t i = place->second; i < way_.size(); ++i)
                cycle_.push_back(way_[i].process);
        if (!visited_.insert(process).second)
            return;
        on_way_[process] = way_.size();
        way_.push_back({process, {}});
        const std::vector<ProgramEnd>& awaited = waits_[process].awaited;
        for (auto end = awaited.rbegin(); end != awaited.rend(); ++end)
            for (const std::size_t partner : partners(*end, process))
                way_.back().partners.push_back(partner);
    }

    const std::vector<ProgramWait>& waits_;
    std::map<ProgramEnd, std::vector<std::size_t>> comes_to_;
    std::vector<WaitStep> way_;
    std::map<std::size_t, std::size_t> on_way_; ///< the place of a process on the way
    std::set<std::size_t> visited_;
    std::vector<std::size_t> cycle_;
};

} // namespace

void add_program_waits(Deadlock& deadlock, const std::vector<ProgramWait>& waits) {
    ProgramWaitGraph graph(waits);
    if (deadlock.cycle.empty())
        for (const std::size_t each : graph.cycle())
            deadlock.cycle.push_back(waits[each].process.path);
    std::set<ProgramEnd> listed;
    for (std::size_t i = 0; i < waits.size(); ++i) {
        deadlock.processes.push_back(waits[i].process);
        for (const ProgramEnd& end : waits[i].awaited) {
            const std::vector<std::size_t> partners = graph.partners(end, i);
            const std::string& own = waits[i].process.path;
            const std::string other = partners.empty() ? "none found" : waits[partners.front()].process.path;
            if (listed.insert(end).second)
                deadlock.channels.push_back({end.channel, end.is_output ? other : own, end.is_output ? own : other,
                                             end.is_output ? "inputter" : "outputter"});
        }
    }
}

} // namespace placedpar
