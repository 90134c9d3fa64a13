#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/stopwatch.hpp"
#include "gaprocs/processes/workload.hpp"
#include "runtime/channel.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// A master and its slaves as evaluator of a population (algorithm A). The master has one link to its slaves,
/// which stand in a chain and pass on what is not for them. It sends to the nearest slave first, evaluates a
/// share itself, then takes in the results. Without slaves it evaluates everything.
///
/// The fitness does not depend on the number of slaves nor on who evaluated what: see fitness.hpp.
class Farm {
public:
    struct Settings {
        std::size_t slaves = 0;
        Split split = Split::individuals;
        bool measurements_every_generation = false; ///< else only when they are new
        bool results_in_order = false;              ///< of the chain, the farthest first; else as they come
        double bias = 0;
    };

    /// The ends are not used when there are no slaves.
    Farm(const SearchProblem&, const Workload&, const Settings&, Output<Task> to_slaves, Input<Fitnesses> from_slaves);

    /// New measurements: the slaves get them with their next task.
    void measure(Window);
    /// The fitness of every individual. REQUIRES: measure() was called.
    std::vector<double> evaluate(std::span<const Genome> population);
    /// The communication of a whole generation, new measurements and all, with nothing evaluated: what the
    /// thesis measured as C_time2. On demand, of as many individuals as are the slaves' when nobody is faster
    /// than another. REQUIRES: slaves > 0.
    void rehearse(std::span<const Genome> population);
    /// Ends the slaves.
    void end();

    /// Starts the times below afresh.
    void forget_times() { send_to_receive = own_evaluation = Stopwatch{}; }
    /// Sending, evaluating, receiving (T_sr); the master's own evaluations (P_time2).
    Stopwatch send_to_receive, own_evaluation;

private:
    class Dealer;

    Task make_task(Task::Kind, std::size_t slave, const Share&, std::span<const Genome> population, bool measurements);
    void send_to_all(Task::Kind, std::span<const Share>, std::span<const Genome> population, bool measurements);
    void take(const Fitnesses&, std::vector<double>& fitness);
    void evaluate_own(const Share&, std::span<const Genome> population, std::vector<double>& fitness);
    void evaluate_dealt_out(std::span<const Genome> population, std::vector<double>& fitness);
    void evaluate_on_demand(std::span<const Genome> population, std::vector<double>& fitness);
    void rehearse_on_demand(std::span<const Genome> population, std::vector<double>& fitness);
    void deal_to_slave(std::size_t slave, Dealer&, Task::Kind, std::span<const Genome> population);

    const SearchProblem& problem_;
    Workload workload_;
    Settings settings_;
    Output<Task> to_slaves_;
    Input<Fitnesses> from_slaves_;
    Window window_;
    bool measurements_are_new_ = false;
};

} // namespace placedpar
