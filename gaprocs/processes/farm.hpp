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

/// Evaluates a population by a master and its slaves (algorithm A). The slaves behind each channel of the master form a
/// tree, and pass on messages for each other. The master may have one channel to a chain of slaves, a channel to each
/// slave of a star, or any other tree. In each generation the master sends the tasks, evaluates its own share, then
/// receives the results. Tasks for the nearest slaves are sent first. Without slaves the master evaluates all
/// individuals.
///
/// The fitness is independent of the number of slaves, of their connections, and of the evaluator of each individual
/// (see fitness.hpp).
class Farm {
public:
    struct Settings {
        std::size_t slaves = 0;
        SlaveRoutes routes = {};
        Split split = Split::individuals;
        double own_share = 1; ///< master's share as a fraction of a slave's share, 0 ... 1; not used by Split::demand
        Sending sending = Sending::in_turn;
        std::size_t tasks_under_way = 1; ///< largest number of unanswered tasks of a slave; for Split::demand
        bool measurements_every_generation =
            false; ///< true: send the measurements in every generation; false: only when they are new
        bool results_in_order = false; ///< true: receive channel by channel, the farthest slave first; false: receive
                                       ///< each result when it is ready
        double bias = 0;
    };

    Farm(const SearchProblem&, const Workload&, const Settings&, std::vector<Output<Task>> to_slaves,
         std::vector<Input<Fitnesses>> from_slaves);

    /// Sets new measurements. Each slave receives them with its next task.
    void measure(Window);
    /// Returns the fitness of every individual. REQUIRES: measure() was called.
    std::vector<double> evaluate(std::span<const Genome> population);
    /// Does all communication of a generation with new measurements, but evaluates nothing. The thesis measured C_time2
    /// in this way. With Split::demand each slave gets 1/(slaves + 1) of the individuals, as if all evaluators had the
    /// same speed. REQUIRES: slaves > 0.
    void rehearse(std::span<const Genome> population);
    /// Ends the slaves.
    void end();

    /// Resets the two stopwatches below.
    void forget_times() { send_to_receive = own_evaluation = Stopwatch{}; }
    /// These stopwatches measure T_sr, the time of a generation from the first sending to the last receiving, and
    /// P_time2, the time of the master's own evaluations.
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
    std::vector<std::size_t> in_turn_; ///< slaves in the order in which the master sends their tasks
    Window window_;
    bool measurements_are_new_ = false;
};

} // namespace placedpar
