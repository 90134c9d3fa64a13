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

/// The master's part of the thesis's algorithm A: evaluates a population with the help of slave processes. Master and
/// slaves form a tree, such as a chain or a star. Slaves pass on messages for the slaves behind them. In each
/// generation the master first sends the tasks, beginning with the nearest slaves, then evaluates its own share, then
/// receives the results. With Split::demand, individuals are instead sent one by one, each to an idle slave or the idle
/// master. Without slaves the master evaluates all individuals.
///
/// The fitness does not depend on the number of slaves, on their connections, or on the process that evaluates an
/// individual (see fitness.hpp).
class Farm {
public:
    struct Settings {
        std::size_t slaves = 0;
        SlaveRoutes routes = {};
        Split split = Split::individuals;
        double own_share = 1; ///< ratio of the master's share to a slave's share, 0 ... 1; ignored with Split::demand
        Sending sending = Sending::in_turn;
        /// Largest number of unanswered tasks that a slave may have; more than 1 only with Split::demand.
        std::size_t tasks_under_way = 1;
        /// True: send the window of measurements in every generation; false: only after measure().
        bool measurements_every_generation = false;
        /// True: receive all results of one channel, beginning with the farthest slave, then the results of the next
        /// channel; false: receive each result when it is ready.
        bool results_in_order = false;
        double bias = 0;
    };

    Farm(const SearchProblem&, const Workload&, const Settings&, std::vector<Output<Task>> to_slaves,
         std::vector<Input<Fitnesses>> from_slaves);

    /// Sets the window, the newest measurements, over which individuals are evaluated. Each slave receives the window
    /// with its next task.
    void measure(Window);
    /// Returns the fitness of every individual. REQUIRES: measure() was called.
    std::vector<double> evaluate(std::span<const Genome> population);
    /// Does all communication of a generation with new measurements, but evaluates nothing. The thesis measured
    /// C_time2, the communication time of a generation, in this way. With Split::demand, the slaves receive
    /// slaves/(slaves + 1) of the individuals, because the master would evaluate the others. REQUIRES: slaves > 0.
    void rehearse(std::span<const Genome> population);
    /// Ends all slaves.
    void end();

    void forget_times() { send_to_receive = own_evaluation = Stopwatch{}; }
    /// `send_to_receive` measures T_sr of the thesis, the time of a generation from the first send to the last receive.
    /// `own_evaluation` measures P_time2 of the thesis, the time of the master's own evaluations.
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
    std::vector<std::size_t> in_turn_; ///< slaves in the order in which the master sends tasks to them
    Window window_;
    bool measurements_are_new_ = false;
};

} // namespace placedpar
