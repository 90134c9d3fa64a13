#include "gaprocs/processes/island_checks.hpp"

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "gaprocs/processes/island_run.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/slave_tree.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

/// The results of most_senders_at_once(), each computed only once. The key is the text of the schedule.
using SendersBySchedule = std::map<std::string, std::vector<std::size_t>>;

class IslandCheck {
public:
    IslandCheck(const Network& network, const Archipelago& archipelago, std::size_t number,
                const ProblemRegistry& problems, SendersBySchedule& senders)
        : problems_(problems), network_(network), archipelago_(archipelago), number_(number), index_(self().process),
          process_(network.processes[index_]), senders_(senders) {}

    std::vector<Complaint> run() {
        check_connections();
        check_topology();
        check_how_often();
        check_emigrants();
        if (complaints_.empty()) {
            check_neighbours_agree();
            check_room();
            warn_of_parts();
            warn_of_no_exchange();
        }
        return std::move(complaints_);
    }

private:
    const PlacedIsland& self() const { return archipelago_.islands()[number_]; }
    const ProcessInstance& instance(std::size_t island) const {
        return network_.processes[archipelago_.islands()[island].process];
    }
    static std::int64_t integer(const ProcessInstance& process, const char* parameter) {
        return std::get<std::int64_t>(process.parameters.at(parameter));
    }
    static const std::string& text(const ProcessInstance& process, const char* parameter) {
        return std::get<std::string>(process.parameters.at(parameter));
    }
    std::string names(const std::vector<std::size_t>& islands) const {
        std::vector<std::string> all;
        for (std::size_t island : islands)
            all.push_back(instance(island).name);
        return all.empty() ? "no island" : fmt::format("{}", fmt::join(all, ", "));
    }
    void refuse(std::string about, std::string message, std::string hint = "") {
        complaints_.push_back({index_, std::move(about), std::move(message), std::move(hint)});
    }

    void check_connections() {
        for (const auto& [port, message] : self().refused)
            refuse(port, message);
    }

    void check_topology() {
        const std::string& topology = text(process_, "topology");
        if (Topology::named(topology).is_given())
            return require_some_neighbour();
        const NamedTopology& expected = archipelago_.topology(topology);
        if (!expected.does_not_fit.empty())
            refuse("topology", expected.does_not_fit);
        else if (!std::ranges::is_permutation(expected.neighbours[number_], self().neighbours))
            refuse("topology",
                   fmt::format("\"{}\" is connected to {}, expected {} in the topology \"{}\" of {} islands",
                               process_.name, names(self().neighbours), names(expected.neighbours[number_]),
                               Topology::named(topology).text(), archipelago_.islands().size()));
    }

    /// Refuses an island without connections if another island has connections, because this is probably a mistake. If
    /// no island has connections, the islands are independent searches.
    void require_some_neighbour() {
        auto connected = [](const PlacedIsland& island) {
            return !island.ports_to.empty() || !island.ports_from.empty();
        };
        if (!connected(self()) && std::ranges::any_of(archipelago_.islands(), connected))
            refuse("", fmt::format("the island \"{}\" has no neighbours, but other islands do", process_.name),
                   "connect its to_neighbours[0] or from_neighbours[0]; for a search that exchanges nothing, use "
                   "ga.master");
    }

    void check_how_often() {
        const std::string& schedule = text(process_, "schedule");
        if (says_how_often(schedule) && process_.given.contains("exchange_every"))
            refuse("exchange_every",
                   fmt::format("exchange_every = {}, but the schedule \"{}\" states an interval, too",
                               integer(process_, "exchange_every"), schedule),
                   "leave out one of the two intervals");
    }

    void check_emigrants() {
        if (self().neighbours.empty())
            return;
        auto emigration = Emigration::named(text(process_, "emigration"));
        try {
            emigration.validate_for(static_cast<std::size_t>(integer(process_, "population")));
            if (auto recorded = named_problem(problems_, process_))
                message_bytes(emigration.count(),
                              string_bytes(integer(process_, "string_bytes"), *recorded->problem()) +
                                  static_cast<std::uint32_t>(integer(process_, "fitness_bytes")));
        } catch (const UserError& too_many) {
            refuse("emigration", too_many.what());
        }
    }

    /// Compares this island's problem, coding and exchanges with the problem, coding and exchanges of the first island
    /// in its group. Islands of a group exchange with each other, directly or through other islands.
    void check_neighbours_agree() {
        const ProcessInstance& first = instance(archipelago_.part_of(number_).front());
        for (const char* parameter : {"problem", "coding"})
            if (text(process_, parameter) != text(first, parameter))
                refuse(parameter, fmt::format("{} = \"{}\" for \"{}\", but \"{}\" for \"{}\", with which it exchanges "
                                              "individuals",
                                              parameter, text(process_, parameter), process_.name,
                                              text(first, parameter), first.name));
        Schedule ours = schedule_of(process_), theirs = schedule_of(first);
        if (ours.in_step() != theirs.in_step() || (ours.in_step() && ours.text() != theirs.text()))
            refuse(process_.given.contains("exchange_every") ? "exchange_every" : "schedule",
                   fmt::format("the schedule of \"{}\" is {}, but the schedule of \"{}\" is {}", process_.name,
                               ours.text(), first.name, theirs.text()),
                   "islands that exchange must have the same schedule");
        else if (ours.in_step())
            check_generations_agree(first);
    }

    void check_generations_agree(const ProcessInstance& first) {
        if (integer(process_, "trials") != integer(first, "trials"))
            refuse("trials",
                   fmt::format("\"trials\" is {} per sample for \"{}\", but {} for \"{}\"",
                               counted(static_cast<std::size_t>(integer(process_, "trials")), "generation"),
                               process_.name, integer(first, "trials"), first.name),
                   "islands that exchange must make equal numbers of generations: give them equal \"trials\" and equal "
                   "numbers of samples");
        auto ours = samples_sent_to(network_, index_, problems_),
             theirs =
                 samples_sent_to(network_, static_cast<std::size_t>(&first - network_.processes.data()), problems_);
        if (ours && theirs && *ours != *theirs)
            refuse("",
                   fmt::format("\"{}\" and \"{}\" are sent different numbers of samples: {} and {}", process_.name,
                               first.name, *ours, *theirs),
                   "islands that exchange must make equal numbers of generations: give them equal \"trials\" and equal "
                   "numbers of samples");
    }

    void check_room() {
        if (integer(process_, "elite") > integer(process_, "population") - 2)
            return; // check_search() reports this
        std::size_t most = most_immigrants_at_once();
        try {
            Acceptance::validate_for(most, static_cast<std::size_t>(integer(process_, "population")),
                                     static_cast<std::size_t>(integer(process_, "elite")));
        } catch (const UserError& too_many) {
            refuse("population", too_many.what());
        }
    }

    std::size_t most_immigrants_at_once() const {
        Schedule schedule = schedule_of(process_);
        auto [known, is_new] = senders_.try_emplace(schedule.text());
        if (is_new)
            known->second = most_senders_at_once(schedule, archipelago_.neighbours());
        std::size_t most = 0;
        for (const auto& [from, port] : self().ports_from)
            most = std::max(most, Emigration::named(text(instance(from), "emigration")).count());
        return known->second[number_] * most;
    }

    void warn(std::size_t island, std::string about, std::string message, std::string hint = "") {
        complaints_.push_back(
            {archipelago_.islands()[island].process, std::move(about), std::move(message), std::move(hint), true});
    }

    /// Warns if individuals of one island never reach another island. Only the check of the first island gives this
    /// warning, for all islands.
    void warn_of_parts() {
        const auto& parts = archipelago_.parts();
        if (number_ != 0)
            return;
        if (parts.size() == 1)
            return warn_of_one_way();
        if (parts.size() == archipelago_.islands().size())
            return warn_of_islands_alone();
        std::vector<std::string> listed;
        for (const auto& part : parts)
            listed.push_back(names(part));
        warn(parts[1].front(), "",
             fmt::format("the islands form {} groups that exchange nothing with each other: {}", parts.size(),
                         fmt::join(listed, "; ")));
    }

    void warn_of_one_way() {
        if (auto lost = one_way(archipelago_.neighbours()))
            warn(lost->from, "",
                 fmt::format("no individual from \"{}\" ever reaches \"{}\"", names({lost->from}),
                             names({lost->never_to})),
                 "to close a ring, connect the last island to the first");
    }

    /// Warns that no island is connected, unless all islands have topology = "none". The warning points to the first
    /// island without topology = "none".
    void warn_of_islands_alone() {
        for (std::size_t island = 0; island < archipelago_.islands().size(); ++island)
            if (Topology::named(text(instance(island), "topology")).is_given())
                return warn(
                    island, "",
                    fmt::format("none of the {} islands is connected to another, so they exchange nothing",
                                archipelago_.islands().size()),
                    "connect to_neighbours[0] of each island; for searches without exchange, set topology = \"none\"");
    }

    /// Warns if the run ends before the first exchange. If islands exchange in step, only the first island of each part
    /// warns.
    void warn_of_no_exchange() {
        Schedule schedule = schedule_of(process_);
        const auto& part = archipelago_.part_of(number_);
        auto run = run_of(network_, archipelago_, number_, problems_);
        if (!run || part.size() == 1 || run->generations() >= schedule.every() ||
            (schedule.in_step() && part.front() != number_))
            return;
        warn(number_, process_.given.contains("exchange_every") ? "exchange_every" : "schedule",
             fmt::format("\"{}\" never exchanges individuals: the first exchange is due after {}, but the run has "
                         "only {}",
                         process_.name, counted(schedule.every(), "generation"), run->generations()));
    }

    const ProblemRegistry& problems_;
    const Network& network_;
    const Archipelago& archipelago_;
    std::size_t number_, index_;
    const ProcessInstance& process_;
    SendersBySchedule& senders_;
    std::vector<Complaint> complaints_;
};

} // namespace

std::vector<Complaint> check_islands(const Network& network, const ProblemRegistry& problems,
                                     const std::function<std::vector<Complaint>(std::size_t process)>& check_search) {
    const Archipelago archipelago(network);
    SendersBySchedule senders;
    std::vector<Complaint> all;
    for (std::size_t i = 0; i < archipelago.islands().size(); ++i) {
        std::ranges::move(check_search(archipelago.islands()[i].process), std::back_inserter(all));
        std::ranges::move(IslandCheck(network, archipelago, i, problems, senders).run(), std::back_inserter(all));
    }
    return all;
}

} // namespace placedpar
