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

/// Collects the estimates that the searches send back to their host. Measures each response time, from the moment at
/// which the search had taken a sample to the arrival of its estimate for that sample, and since when the fittest
/// estimate has been accurate.
class Estimates {
public:
    /// REQUIRES: a network that has passed check_host(), so that every estimate comes from a search that takes samples
    /// of this host. Both must outlive it. Throws UserError if an accuracy is given and the problem's record was not
    /// simulated.
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
    /// The arrival of the estimate that followed this number of samples.
    struct Answer {
        std::size_t samples;
        Time came;
    };
    Time response(std::size_t search, const Answer&) const;
    void report_responses(std::size_t received) const;
    /// Returns the search whose last estimate is the fittest; searches() if no estimate has come.
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
    // The times are compared only at the end: parallel processes note them, and the order of their notes must not
    // matter.
    std::map<std::size_t, std::vector<Time>> taken_{}; ///< times at which each sample had been taken, by process
    std::vector<std::vector<Answer>> answers_;         ///< by search
    double accuracy_;                      ///< largest relative error of an accurate estimate; 0: not checked
    std::optional<Time> accurate_since_{}; ///< since when the fittest estimate has been accurate without a break
};

/// Reports the fitness or objective of an individual and its parameters as measurements of the process. `values`: the
/// decoded parameters; empty if the problem's strings do not code numbers, in which case the string is reported.
void measure_individual(ProcessEnvironment&, const SearchProblem&, const Individual&,
                        const std::vector<double>& values);

} // namespace placedpar
