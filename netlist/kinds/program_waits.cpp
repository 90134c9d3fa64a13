#include "netlist/kinds/program_waits.hpp"

#include "netlist/network/network.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>

namespace placedpar {

namespace {

/// Finds which processes wait for which other processes in a deadlock. Each process has a number. First come the
/// processes of booted programs, the machine code of emulated transputers. Then come the processes in the report of the
/// deadlock.
class ProgramWaitGraph {
    static constexpr std::size_t no_process = static_cast<std::size_t>(-1);

public:
    ProgramWaitGraph(const Deadlock& deadlock, const std::vector<ProgramWait>& waits, const Network& network) {
        for (const ProgramWait& each : waits)
            add(each.process.path, each.awaited);
        for (const StuckProcess& each : deadlock.processes)
            add(each);
        for (std::size_t i = 0; i < waits.size(); ++i)
            for (const ProgramEnd& end : waits[i].ahead)
                comes_to_[end].push_back(i);
        for (const NetworkChannel& each : network.channels)
            if (const ChannelEnd* code = each.end_at_code()) {
                const ChannelEnd& user = code == &each.to ? each.from : each.to;
                add_user({each.name, code == &each.to}, network.processes[user.process].name);
            }
        for (const StuckChannel& each : deadlock.channels)
            if (!comes_to_.contains({each.name, true}) && !comes_to_.contains({each.name, false}))
                for (const bool is_output : {true, false})
                    add_user({each.name, is_output}, is_output ? each.outputter : each.inputter);
    }

    const std::string& path(std::size_t process) const { return waiting_[process].path; }

    /// Returns the processes that could use this end of a channel, except `waiting`.
    std::vector<std::size_t> partners(const ProgramEnd& end, std::size_t waiting = no_process) const {
        const auto found = comes_to_.find(end);
        std::vector<std::size_t> result = found == comes_to_.end() ? std::vector<std::size_t>{} : found->second;
        std::erase(result, waiting);
        return result;
    }

    /// Returns the process of the netlist that used this end of a channel until the process ended, or "none found".
    std::string ended_user(const ProgramEnd& end) const {
        const auto found = ended_users_.find(end);
        return found == ended_users_.end() ? "none found" : found->second + " (has ended)";
    }

    /// Returns a cycle of processes that wait for each other; empty if there is none. Searches depth first.
    std::vector<std::size_t> cycle() {
        for (std::size_t i = 0; i < waiting_.size(); ++i)
            if (step_to(i); follow())
                return cycle_;
        return {};
    }

private:
    struct Waiting {
        std::string path;
        std::vector<ProgramEnd> awaited;
        std::vector<std::size_t> components = {}; ///< components of a PAR for whose end the process waits
    };
    struct WaitStep {
        std::size_t process;
        std::vector<std::size_t> partners;
    };

    void add(const std::string& path, const std::vector<ProgramEnd>& awaited) {
        numbers_.emplace(path, waiting_.size());
        waiting_.push_back({path, awaited});
    }

    /// Adds a process of the report. In the report, a component of a PAR comes after the process that started it.
    void add(const StuckProcess& process) {
        const auto parent = numbers_.find(process.path.substr(0, process.path.rfind('/')));
        if (parent != numbers_.end())
            waiting_[parent->second].components.push_back(waiting_.size());
        add(process.path, {});
        for (const std::string& channel : process.channels)
            waiting_.back().awaited.push_back({channel, process.activity != Activity::outputting});
    }

    void add_user(const ProgramEnd& end, const std::string& user) {
        if (const auto found = numbers_.find(user); found != numbers_.end())
            comes_to_[end].push_back(found->second);
        else
            ended_users_.emplace(end, user);
    }

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
        way_.push_back({process, awaited_by(process)});
    }

    /// Returns the processes for which a process waits. The search continues with the last of them.
    std::vector<std::size_t> awaited_by(std::size_t process) const {
        std::vector<std::size_t> result;
        std::ranges::copy(waiting_[process].components, std::back_inserter(result));
        const std::vector<ProgramEnd>& awaited = waiting_[process].awaited;
        for (auto end = awaited.rbegin(); end != awaited.rend(); ++end)
            std::ranges::copy(partners(*end, process), std::back_inserter(result));
        return result;
    }

    std::vector<Waiting> waiting_;
    std::map<std::string, std::size_t> numbers_; ///< number of each process; key: path
    std::map<ProgramEnd, std::vector<std::size_t>> comes_to_;
    std::map<ProgramEnd, std::string> ended_users_;
    std::vector<WaitStep> way_;
    std::map<std::size_t, std::size_t> on_way_; ///< for each process of the search path: its position in way_
    std::set<std::size_t> visited_;
    std::vector<std::size_t> cycle_;
};

/// Writes the names of processes of programs into the rows of the report for channels that lead to these processes.
void name_partners(std::vector<StuckChannel>& rows, const ProgramWaitGraph& graph) {
    for (StuckChannel& row : rows) {
        const bool outputs = row.waiting == "outputter";
        if (const auto partners = graph.partners({row.name, !outputs}); !partners.empty())
            (outputs ? row.inputter : row.outputter) = graph.path(partners.front());
    }
}

/// Adds a row to the report for a channel at which a process of a program waits. The report already has a row if a
/// process of the netlist waits at the other end, because bytes were lost. This row then gets the name of the program's
/// process.
void add_row(std::vector<StuckChannel>& rows, const std::string& own, const std::string& other, const ProgramEnd& end) {
    const auto known = std::ranges::find(rows, end.channel, &StuckChannel::name);
    if (known == rows.end())
        rows.push_back({end.channel, end.is_output ? other : own, end.is_output ? own : other,
                        end.is_output ? "inputter" : "outputter"});
    else if ((known->waiting == "outputter") == end.is_output)
        (end.is_output ? known->inputter : known->outputter) = own;
}

} // namespace

void add_program_waits(Deadlock& deadlock, const std::vector<ProgramWait>& waits, const Network& network) {
    ProgramWaitGraph graph(deadlock, waits, network);
    if (deadlock.cycle.empty())
        for (const std::size_t each : graph.cycle())
            deadlock.cycle.push_back(graph.path(each));
    name_partners(deadlock.channels, graph);
    for (std::size_t i = 0; i < waits.size(); ++i) {
        deadlock.processes.push_back(waits[i].process);
        for (const ProgramEnd& end : waits[i].awaited) {
            const std::vector<std::size_t> partners = graph.partners(end, i);
            add_row(deadlock.channels, waits[i].process.path,
                    partners.empty() ? graph.ended_user(end) : graph.path(partners.front()), end);
        }
    }
}

} // namespace placedpar
