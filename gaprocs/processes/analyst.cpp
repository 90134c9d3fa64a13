#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/active_error_analysis.hpp"
#include "gaprocs/processes/analyst_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/peers.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/window.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

namespace {

using namespace search_description;

struct AnalysedIsland {
    std::string name;
    std::size_t window;
    Input<EstimateMessage> reports;
};

std::vector<AnalysedIsland> islands_of(const ProcessEnvironment& environment) {
    std::vector<AnalysedIsland> islands;
    for (const auto& [port, process] : peers_at(environment.network(), environment.index(), "from_islands")) {
        const ProcessInstance& island = environment.network().processes[process];
        islands.push_back({island.name,
                           static_cast<std::size_t>(std::get<std::int64_t>(island.parameters.at("window"))),
                           environment.input<EstimateMessage>(port)});
    }
    return islands;
}

std::vector<std::size_t> windows_of(const std::vector<AnalysedIsland>& islands) {
    std::vector<std::size_t> windows;
    std::ranges::transform(islands, std::back_inserter(windows), &AnalysedIsland::window);
    return windows;
}

/// Receives the best individual of each island, and chooses one of them as the answer by active error analysis.
/// REQUIRES: the network has passed check_analyst(); this ensures that there is at least one island, and that all
/// islands have the same host.
class Analyst {
public:
    Analyst(ProcessEnvironment& environment, const SearchProblem& problem, SearchObserver* observer)
        : environment_(environment), problem_(problem), observer_(observer),
          from_host_(environment.input<HostMessage>("from_host")), islands_(islands_of(environment)),
          longest_window_(std::ranges::max(windows_of(islands_))),
          samples_({.length = longest_window_, .first = longest_window_}),
          analysis_(problem, windows_of(islands_), IslandChoice::named(environment.text("choice")),
                    environment.random_stream(environment.process())) {}

    void run() {
        for (auto reports = receive_reports(); !reports.front().end; reports = receive_reports()) {
            take_samples(reports.front().samples);
            if (samples_.ready())
                analyse(reports);
        }
        take_what_is_left();
        report();
    }

private:
    /// Receives one report from each island; the inputs run in parallel.
    std::vector<EstimateMessage> receive_reports() {
        std::vector<EstimateMessage> reports(islands_.size());
        par_for(reports.size(), [&](std::size_t i) { reports[i] = islands_[i].reports.input(); });
        return reports;
    }

    /// Receives samples from the host until the analyst has received `count` samples. An island's report states this
    /// number.
    void take_samples(std::size_t count) {
        for (; taken_ < count; ++taken_)
            samples_.push(from_host_.input().sample);
    }

    void take_what_is_left() {
        while (!from_host_.input().end) {
        }
    }

    /// Returns the number of error evaluations in one analysis. Each best individual is evaluated at the samples of the
    /// longest window. If the error depends on where the window begins, the individual is evaluated in each window
    /// separately.
    std::size_t errors_to_find() const {
        const std::vector<std::size_t> windows = windows_of(islands_);
        std::size_t of_each = problem_.depends_on_window()
                                  ? std::accumulate(windows.begin(), windows.end(), std::size_t{0})
                                  : longest_window_;
        return islands_.size() * of_each;
    }

    void analyse(const std::vector<EstimateMessage>& reports) {
        compute(static_cast<std::int64_t>(errors_to_find()) * Cycles{environment_.integer("cycles_per_error")});
        std::vector<Individual> bests;
        std::ranges::transform(reports, std::back_inserter(bests), &EstimateMessage::best);
        analysis_.analyse(bests, samples_.samples());
        ++answers_;
        if (observer_)
            observer_->observe(ObservedAnswer{environment_.process(), chosen(), reports.front().generation, now(),
                                              problem_.parameter_names(), answer()});
    }

    const std::string& chosen() const { return islands_[analysis_.island()].name; }
    std::vector<double> answer() const { return problem_.decode(analysis_.answer().genome); }

    void report() const {
        environment_.measure("answers", static_cast<double>(answers_));
        if (answers_ == 0)
            return;
        environment_.measure("chosen", chosen());
        auto names = problem_.parameter_names(), units = problem_.parameter_units();
        auto values = answer();
        for (std::size_t i = 0; i < values.size(); ++i)
            environment_.measure(names[i], values[i], units[i]);
    }

    ProcessEnvironment& environment_;
    const SearchProblem& problem_;
    SearchObserver* observer_; ///< null: no observer
    Input<HostMessage> from_host_;
    std::vector<AnalysedIsland> islands_;
    std::size_t longest_window_;
    SlidingWindow samples_; ///< the newest samples, as many as in the longest window
    std::size_t taken_ = 0; ///< number of samples received
    ActiveErrorAnalysis analysis_;
    std::size_t answers_ = 0;
};

/// Runs an analyst with the problem and the coding of the first island. check_islands() has checked that all islands
/// that exchange have the same problem and coding.
void run_analyst(ProcessEnvironment& environment, const ProblemRegistry& problems, SearchObserver* observer) {
    const Network& network = environment.network();
    std::size_t first = peers_at(network, environment.index(), "from_islands").front().process;
    auto text = [&](const char* parameter) {
        return std::get<std::string>(network.processes[first].parameters.at(parameter));
    };
    auto problem = problems.find(text("problem")).problem()->coded(Coding::named(text("coding")));
    Analyst(environment, *problem, observer).run();
}

} // namespace

ProcessKind analyst_kind(const ProblemRegistry& problems, SearchObserver* observer) {
    using namespace description;
    return {
        .name = "ga.analyst",
        .about = "Active error analysis (thesis 5.3.2) of islands with different windows. After each exchange it "
                 "chooses the island whose best individual is the answer of all islands, and keeps this answer until "
                 "the next exchange. It does not affect the islands.",
        .ports = {from_host(), input<EstimateMessage>("from_islands", "estimate", "an array: one end for each island")},
        .parameters = {policy<IslandChoice>(
                           "choice", "row",
                           "how the island is chosen; islands are numbered in the order of from_islands"),
                       cycles_per_error()},
        .measurements = {{"answers", "",
                          "number of answers; the first is given when the windows of all islands are full"},
                         {"chosen", "", "the island whose best individual is the last answer"},
                         {"the problem's parameters", "", "as decoded from the best individual of that island"}},
        .body = [&problems,
                 observer](ProcessEnvironment& environment) { run_analyst(environment, problems, observer); },
        .check = [&problems](const Network& network,
                             std::size_t process) { return check_analyst(network, process, problems); }};
}

} // namespace placedpar
