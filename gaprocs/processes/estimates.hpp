#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/processes/messages.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace placedpar {

/// What the searches send back to their host, and how long each took: from when a search had taken a sample until its
/// estimate of that sample had come; and since when the fittest of them has been accurate.
class Estimates {
public:
    /// REQUIRES: a network that has passed check_host(), so that every estimate comes from a search that takes samples
    /// of this host. Both must outlive it. Throws UserError where an accuracy is asked for of a problem whose record
    /// was not simulated.
    Estimates(ProcessEnvironment&, const ProblemRegistry&);

    /// How many searches send any.
    std::size_t searches() const { return last_.size(); }
    /// That process of the network has now taken one more sample.
    void note_taken(std::size_t process);
    /// Receives those of one search until it ends. Each wants a process of its own, beside those that send samples: a
    /// search does not take the next sample before its estimate is taken.
    void receive(std::size_t search);
    /// How many came, how long they took, and what the fittest of the searches' last ones says; nothing where no search
    /// sends any.
    void report() const;

private:
    /// Returns when the estimate of this number of samples came.
    struct Answer {
        std::size_t samples;
        Time came;
    };
    Time response(std::size_t search, const Answer&) const;
    void report_responses(std::size_t received) const;
    /// The last estimate that is the fittest; searches() where none has come.
    std::size_t fittest() const;
    std::shared_ptr<const SearchProblem> problem_of(std::size_t search) const;
    std::vector<double> values_of(std::size_t search) const;
    void judge_fittest();
    void report_fittest() const;

    ProcessEnvironment& environment_;
    const ProblemRegistry& problems_;
    std::vector<std::size_t> processes_;         ///< by search: where in the network it is
    std::vector<Input<EstimateMessage>> inputs_; ///< by search
    std::vector<EstimateMessage> last_;          ///< by search; of generation 0 where none has come
    // Compared only at the end, since each is another component's: so it makes no difference who notes first.
    std::map<std::size_t, std::vector<Time>> taken_{}; ///< by process: when it had taken each sample
    std::vector<std::vector<Answer>> answers_;         ///< by search
    double accuracy_; ///< how far the fittest may be from the truth, as a part of it; 0: not judged
    std::optional<Time> accurate_since_{}; ///< has been that near
};

/// What an individual is worth and stands for, as measurements of the process. `values`: decoded, none where the
/// problem's strings stand for no numbers.
void measure_individual(ProcessEnvironment&, const SearchProblem&, const Individual&,
                        const std::vector<double>& values);

} // namespace placedpar
