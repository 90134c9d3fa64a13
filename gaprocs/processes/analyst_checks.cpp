#include "gaprocs/processes/analyst_checks.hpp"

#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "gaprocs/processes/island_run.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/peers.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

class AnalystCheck {
public:
    AnalystCheck(const Network& network, std::size_t analyst, const ProblemRegistry& problems)
        : network_(network), analyst_(analyst), problems_(problems),
          reporters_(peers_at(network, analyst, "from_islands")) {}

    std::vector<Complaint> run() {
        check_islands();
        if (complaints_.empty()) {
            check_steps();
            check_record();
            check_host();
            check_choice();
            if (complaints_.empty())
                warn_of_no_answer();
        }
        return std::move(complaints_);
    }

private:
    const ProcessInstance& instance(std::size_t process) const { return network_.processes[process]; }
    const std::string& name(std::size_t process) const { return instance(process).name; }
    std::size_t first_island() const { return reporters_.front().process; }
    void refuse(std::string about, std::string message, std::string hint = "") {
        complaints_.push_back({analyst_, std::move(about), std::move(message), std::move(hint)});
    }

    void check_islands() {
        for (const auto& [port, process] : reporters_)
            if (process == nowhere || instance(process).kind != "ga.island")
                refuse(port, fmt::format("\"{}.{}\" is not connected to an island", name(analyst_), port));
    }

    void check_steps() {
        const char* why = "an analyst compares best individuals of the same generation: its islands must exchange with "
                          "each other, and not asynchronously";
        if (!schedule_of(instance(first_island())).in_step())
            return refuse("", "islands with an asynchronous schedule are not all in the same generation", why);
        Archipelago archipelago(network_);
        auto together = archipelago.part_of(archipelago.number_of(first_island()));
        for (const auto& [port, process] : reporters_)
            if (std::ranges::count(together, archipelago.number_of(process)) == 0)
                refuse(port,
                       fmt::format("\"{}\" and \"{}\" do not exchange with each other", name(first_island()),
                                   name(process)),
                       why);
    }

    void check_record() {
        const ProcessInstance& island = instance(first_island());
        auto recorded = named_problem(problems_, island);
        if (recorded && recorded->problem()->objective())
            refuse("", fmt::format("the problem \"{}\" has no record of measurements that \"{}\" could analyse",
                                   std::get<std::string>(island.parameters.at("problem")), name(analyst_)));
    }

    /// REQUIRES: every port `from_host` is connected, which the reader of netlists has checked.
    void check_host() {
        auto host = [&](std::size_t process) { return other_end(network_, process, "from_host")->process; };
        for (const Peer& each : reporters_)
            if (host(each.process) != host(analyst_))
                return refuse("from_host",
                              fmt::format("\"{}\" does not get its samples from the same process as \"{}\"",
                                          name(analyst_), name(each.process)));
    }

    void check_choice() {
        try {
            IslandChoice::named(std::get<std::string>(instance(analyst_).parameters.at("choice")))
                .validate_for(reporters_.size());
        } catch (const UserError& not_there) {
            refuse("choice", not_there.what());
        }
    }

    std::size_t longest_window() const {
        std::int64_t longest = 0;
        for (const Peer& each : reporters_)
            longest = std::max(longest, std::get<std::int64_t>(instance(each.process).parameters.at("window")));
        return static_cast<std::size_t>(longest);
    }

    /// Warns if the longest window is not full even at the last exchange, because the analyst answers only at an
    /// exchange with full windows.
    void warn_of_no_answer() {
        Archipelago archipelago(network_);
        auto run = run_of(network_, archipelago, archipelago.number_of(first_island()), problems_);
        if (!run)
            return;
        std::size_t every = schedule_of(instance(first_island())).every(),
                    last = run->generations() / every * every; // generation of the last exchange; 0 if there is none
        if (last > 0 && run->samples_at(last) >= longest_window())
            return;
        std::string why = last == 0
                              ? fmt::format("the first exchange is due after {}, but the run has only {}",
                                            counted(every, "generation"), run->generations())
                              : fmt::format("the last exchange comes after {} samples, but the longest window needs {}",
                                            run->samples_at(last), longest_window());
        complaints_.push_back({analyst_, "", fmt::format("\"{}\" gives no answer: {}", name(analyst_), why), "", true});
    }

    const Network& network_;
    std::size_t analyst_;
    const ProblemRegistry& problems_;
    std::vector<Peer> reporters_;
    std::vector<Complaint> complaints_;
};

} // namespace

std::vector<Complaint> check_analyst(const Network& network, std::size_t process, const ProblemRegistry& problems) {
    return AnalystCheck(network, process, problems).run();
}

} // namespace placedpar
