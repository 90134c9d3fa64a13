#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/slave_routes.hpp"
#include "gaprocs/processes/stopwatch.hpp"
#include "gaprocs/processes/task_outlets.hpp"
#include "gaprocs/processes/workload.hpp"
#include "runtime/channel.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Evaluates a population by a master and its slaves (algorithm A). The slaves behind each of the master's channels
/// form a tree and pass on each other's messages: one channel to a chain, a channel to each slave of a star, or
/// anything between. The master sends to the nearest slaves first, evaluates a share itself, then receives the results.
/// Without slaves it evaluates everything.
///
/// The fitness depends neither on the slaves' number and form nor on which of them evaluated what: see fitness.hpp.
class Farm {
public:
    struct Settings {
        std::size_t slaves = 0;
        SlaveRoutes routes = {};
        Split split = Split::individuals;
        double own_share =
            1; ///< the master's share of the evaluations, relative to a slave's; not used by Split::demand
        Sending sending = Sending::in_turn;
        std::size_t tasks_under_way = 1; ///< sent to a slave before the first of them is answered; for Split::demand
        bool measurements_every_generation = false; ///< else only when they are new
        bool results_in_order = false; ///< channel by channel, the farthest slave's first; else as they become ready
        double bias = 0;
    };

    Farm(const SearchProblem&, const Workload&, const Settings&, std::vector<Output<Task>> to_slaves,
         std::vector<Input<Fitnesses>> from_slaves);

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
    void send(Task);
    void send_to_all(Task::Kind, std::span<const Share>, std::span<const Genome> population, bool measurements);
    Fitnesses receive();
    void take_from_all(std::vector<double>& fitness);
    void take(const Fitnesses&, std::vector<double>& fitness);
    void evaluate_own(const Share&, std::span<const Genome> population, std::vector<double>& fitness);
    void evaluate_dealt_out(std::span<const Genome> population, std::vector<double>& fitness);
    void evaluate_on_demand(std::span<const Genome> population, std::vector<double>& fitness);
    void deal_to_all(Dealer&, std::span<const Genome> population, std::vector<double>& fitness);
    void rehearse_on_demand(std::span<const Genome> population, std::vector<double>& fitness);
    void deal_to_slaves(Dealer&, Task::Kind, std::span<const Genome> population);
    void deal_to_slave(std::size_t slave, Dealer&, Task::Kind, std::span<const Genome> population);

    const SearchProblem& problem_;
    Workload workload_;
    Settings settings_;
    TaskOutlets to_slaves_;
    std::vector<Input<Fitnesses>> from_slaves_;
    std::vector<std::size_t> in_turn_; ///< the slaves, in the order in which they are sent tasks
    Window window_;
    bool measurements_are_new_ = false;
};

} // namespace placedpar
