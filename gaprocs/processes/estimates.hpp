#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/processes/messages.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace placedpar {

/// Collects the estimates (best individuals) that searches send to their host, the process that sends them samples.
/// Measures response times. A response time begins when a search has taken a sample, and ends when the search's
/// estimate after this sample arrives. Also measures the time after which the fittest estimate stays accurate.
class Estimates {
public:
    /// REQUIRES: the network has passed check_host(), that is, each estimate comes from a search that gets its samples
    /// from this host. The environment and the registry outlive this object. Throws UserError if the netlist's
    /// parameter `accuracy` is above 0, but the problem's true parameters are unknown.
    Estimates(ProcessEnvironment&, const ProblemRegistry&);

    /// Returns the number of searches that send estimates.
    std::size_t searches() const { return last_.size(); }
    /// Notes that the search `process` (index in Network::processes) has taken its next sample now.
    void note_taken(std::size_t process);
    /// Receives the estimates of one search until the search ends. After each estimate, calls `received` with the
    /// number of samples that the search had received. Call this function for each search in a process of its own, in
    /// parallel with the processes that send samples. Otherwise the run may deadlock, because a search takes no further
    /// sample until its estimate has been received.
    void receive(std::size_t search, const std::function<void(std::size_t samples)>& received);
    /// Compares the last estimates of all searches, and returns the parameters of the fittest. REQUIRES: an estimate
    /// has been received.
    std::vector<double> fittest_values() const { return values_of(fittest()); }
    /// Reports as measurements: the number of estimates, the response times, and the fittest of the last estimates of
    /// all searches. Does nothing if no search sends estimates.
    void report() const;

private:
    /// The arrival of an estimate.
    struct Answer {
        std::size_t samples; ///< number of samples that the search had received
        Time came;
    };
    Time response(std::size_t search, const Answer&) const;
    void report_responses(std::size_t received) const;
    /// Returns the index of the search with the fittest last estimate; searches() if there are no estimates.
    std::size_t fittest() const;
    std::shared_ptr<const SearchProblem> problem_of(std::size_t search) const;
    std::vector<double> values_of(std::size_t search) const;
    void judge_fittest();
    void report_fittest() const;

    ProcessEnvironment& environment_;
    const ProblemRegistry& problems_;
    std::vector<std::size_t> processes_;         ///< index in Network::processes, by search
    std::vector<Input<EstimateMessage>> inputs_; ///< by search
    std::vector<EstimateMessage> last_; ///< last estimate, by search; its generation is 0 if there is no estimate yet
    // The response times are computed after the run, because parallel processes may note their times in any order.
    /// By process: the times at which it took its first, second, ... sample.
    std::map<std::size_t, std::vector<Time>> taken_{};
    std::vector<std::vector<Answer>> answers_; ///< by search
    double accuracy_;                          ///< largest relative error of an accurate estimate; 0: not checked
    std::optional<Time> accurate_since_{};     ///< time since which the fittest estimate has always been accurate
};

/// Reports an individual's fitness or objective, and its parameters, as results of the process in the run's report.
/// `values`: the decoded parameters. If `values` is empty, because the strings do not code numbers, the string itself
/// is reported.
void measure_individual(ProcessEnvironment&, const SearchProblem&, const Individual&,
                        const std::vector<double>& values);

} // namespace placedpar
