#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/stopwatch.hpp"
#include "gaprocs/processes/workload.hpp"
#include "runtime/channel.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Evaluates a population by a master and its slaves (algorithm A). The master has one link to its slaves, which form a
/// chain and pass on each other's messages. It sends to the nearest slave first, evaluates a share itself, then
/// receives the results. Without slaves it evaluates everything.
///
/// The fitness depends neither on the number of slaves nor on which of them evaluated what: see fitness.hpp.
class Farm {
public:
    struct Settings {
        std::size_t slaves = 0;
        Split split = Split::individuals;
        bool measurements_every_generation = false; ///< else only when they are new
        bool results_in_order = false;              ///< the farthest slave's first; else as they become ready
        double bias = 0;
    };

    /// Without slaves the channel ends are not used.
    Farm(const SearchProblem&, const Workload&, const Settings&, Output<Task> to_slaves, Input<Fitnesses> from_slaves);

    /// New measurements: each slave is sent them with its next task.
    void measure(Window);
    /// The fitness of every individual. REQUIRES: measure() was called.
    std::vector<double> evaluate(std::span<const Genome> population);
    /// All communication of a generation with new measurements, and no evaluation: the thesis measured C_time2 this
    /// way. With on-demand dealing, assumes equal speeds: each slave gets 1/(slaves + 1). REQUIRES: slaves > 0.
    void rehearse(std::span<const Genome> population);
    /// Ends the slaves.
    void end();

    /// Resets the two stopwatches below.
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
