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

/// Collects the estimates that the searches send back to their host. Measures each response time: from the time at
/// which the search has taken a sample, until its estimate for this sample arrives. Measures also the time after which
/// the fittest estimate stays accurate.
class Estimates {
public:
    /// REQUIRES: the network has passed check_host(), so each estimate comes from a search that takes samples from this
    /// host. The environment and the registry outlive this object. Throws UserError if an accuracy is given, but the
    /// problem's record was not simulated.
    Estimates(ProcessEnvironment&, const ProblemRegistry&);

    /// Returns the number of searches that send estimates.
    std::size_t searches() const { return last_.size(); }
    /// Notes that the process has taken one more sample at the current time.
    void note_taken(std::size_t process);
    /// Receives the estimates of one search until the search ends. Call it for each search in a process of its own,
    /// parallel to the processes that send samples: a search takes no further sample until its estimate has been
    /// received. Calls `received` after each estimate, with the number of samples that it followed.
    void receive(std::size_t search, const std::function<void(std::size_t samples)>& received);
    /// Returns the parameters of the fittest of the last estimates. REQUIRES: an estimate has been received.
    std::vector<double> fittest_values() const { return values_of(fittest()); }
    /// Reports, as measurements, the number of estimates, the response times, and the fittest of the searches' last
    /// estimates. Does nothing if no search sends estimates.
    void report() const;

private:
    /// The arrival of an estimate.
    struct Answer {
        std::size_t samples; ///< samples that the search had received
        Time came;
    };
    Time response(std::size_t search, const Answer&) const;
    void report_responses(std::size_t received) const;
    /// Returns the search with the fittest last estimate; searches() if no estimate has come.
    std::size_t fittest() const;
    std::shared_ptr<const SearchProblem> problem_of(std::size_t search) const;
    std::vector<double> values_of(std::size_t search) const;
    void judge_fittest();
    void report_fittest() const;

    ProcessEnvironment& environment_;
    const ProblemRegistry& problems_;
    std::vector<std::size_t> processes_;         ///< index in Network::processes, by search
    std::vector<Input<EstimateMessage>> inputs_; ///< by search
    std::vector<EstimateMessage> last_;          ///< last estimate, by search; generation 0: no estimate yet
    // Times are compared only after the run, because the parallel processes note them in any order.
    std::map<std::size_t, std::vector<Time>> taken_{}; ///< times at which samples were taken, in the order of the
                                                       ///< samples; by process
    std::vector<std::vector<Answer>> answers_;         ///< by search
    double accuracy_;                      ///< largest relative error of an accurate estimate; 0: not checked
    std::optional<Time> accurate_since_{}; ///< start of the time during which the fittest estimate has been accurate
                                           ///< without a break
};

/// Reports the individual's fitness or objective, and its parameters, as measurements of the process. `values`: the
/// decoded parameters. If `values` is empty, the problem's strings do not code numbers, and the string itself is
/// reported.
void measure_individual(ProcessEnvironment&, const SearchProblem&, const Individual&,
                        const std::vector<double>& values);

} // namespace placedpar
