#include "gaprocs/processes/farm.hpp"

#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"

#include <utility>

namespace placedpar {

Farm::Farm(const SearchProblem& problem, const Workload& workload, const Settings& settings,
           std::vector<Output<Task>> to_slaves, std::vector<Input<Fitnesses>> from_slaves)
    : problem_(problem), workload_(workload), settings_(settings), to_slaves_(std::move(to_slaves), settings.sending),
      from_slaves_(std::move(from_slaves)), in_turn_(settings.routes.in_turn(settings.slaves)) {}

void Farm::measure(Window window) {
    window_ = std::move(window);
    measurements_are_new_ = true;
}

std::vector<double> Farm::evaluate(std::span<const Genome> population) {
    std::vector<double> fitness(population.size(), 0.0);
    send_to_receive.start();
    if (settings_.split == Split::demand && settings_.slaves > 0)
        evaluate_on_demand(population, fitness);
    else
        evaluate_dealt_out(population, fitness);
    send_to_receive.stop();
    measurements_are_new_ = settings_.measurements_every_generation;
    return fitness;
}

void Farm::evaluate_dealt_out(std::span<const Genome> population, std::vector<double>& fitness) {
    auto shares = deal(population.size(), window_->size(), settings_.slaves, settings_.split, settings_.own_share);
    send_to_all(Task::Kind::evaluate, shares, population, measurements_are_new_);
    own_evaluation.start();
    evaluate_own(shares.back(), population, fitness);
    own_evaluation.stop();
    take_from_all(fitness);
}

void Farm::rehearse(std::span<const Genome> population) {
    std::vector<double> fitness(population.size());
    if (settings_.split == Split::demand)
        return rehearse_on_demand(population, fitness);
    auto shares = deal(population.size(), window_->size(), settings_.slaves, settings_.split, settings_.own_share);
    send_to_all(Task::Kind::rehearse, shares, population, true);
    take_from_all(fitness);
}

void Farm::end() {
    if (settings_.slaves == 0)
        return;
    to_slaves_.during([this] {
        for (std::size_t channel = 0; channel < to_slaves_.count(); ++channel)
            to_slaves_.send(channel, Task{});
    });
    for (const Input<Fitnesses>& from : from_slaves_)
        while (!from.input().end) {
        }
}

void Farm::send(Task task) {
    auto [channel, address] = settings_.routes.to(task.slave);
    task.address = address;
    to_slaves_.send(channel, std::move(task));
}

void Farm::send_to_all(Task::Kind kind, std::span<const Share> shares, std::span<const Genome> population,
                       bool measurements) {
    to_slaves_.during([&] {
        for (std::size_t slave : in_turn_)
            send(make_task(kind, slave, shares[slave], population, measurements));
    });
}

/// Waits for the next result of any slave, and returns it.
Fitnesses Farm::receive() {
    if (from_slaves_.size() == 1)
        return from_slaves_.front().input();
    Fitnesses next;
    alt(std::span<const Input<Fitnesses>>(from_slaves_),
        [&](std::size_t, Fitnesses result) { next = std::move(result); });
    return next;
}

/// Receives the results of all slaves. With Settings::results_in_order, the result of the nearest slave is the last
/// result on each channel.
void Farm::take_from_all(std::vector<double>& fitness) {
    if (!settings_.results_in_order || from_slaves_.size() == 1) {
        for (std::size_t slave = 0; slave < settings_.slaves; ++slave)
            take(receive(), fitness);
        return;
    }
    for (const Input<Fitnesses>& from : from_slaves_)
        for (bool last = false; !last;) {
            Fitnesses result = from.input();
            last = result.hops == 0;
            take(result, fitness);
        }
}

/// Makes a task. Spends the simulated time of the copy of the strings, and of the conversion of each word of the
/// measurements.
Task Farm::make_task(Task::Kind kind, std::size_t slave, const Share& share, std::span<const Genome> population,
                     bool measurements) {
    Task task;
    task.kind = kind;
    task.slave = slave;
    task.share = share;
    auto strings = population.subspan(share.first_individual(), share.individuals());
    task.strings.assign(strings.begin(), strings.end());
    task.bias = settings_.bias;
    task.coding = problem_.coding();
    task.results_in_order = settings_.results_in_order;
    task.tasks_under_way = settings_.tasks_under_way;
    task.bytes = message_bytes(strings.size(), workload_.string_bytes);
    compute(block_move(task.bytes));
    if (measurements) {
        task.window = window_;
        task.bytes = message_bytes(strings.size(), workload_.string_bytes, workload_.measurement_bytes);
        compute((workload_.measurement_bytes + 3) / 4 * workload_.measurement_conversion);
    }
    return task;
}

/// Adds the terms of a result to the fitness, and spends the simulated time for copying the message.
void Farm::take(const Fitnesses& result, std::vector<double>& fitness) {
    compute(block_move(result.bytes));
    add_terms(result.share, result.terms, fitness);
}

void Farm::evaluate_own(const Share& share, std::span<const Genome> population, std::vector<double>& fitness) {
    compute(static_cast<std::int64_t>(share.evaluations()) * workload_.error_evaluation);
    auto strings = population.subspan(share.first_individual(), share.individuals());
    add_terms(share, evaluate_share(problem_, share, strings, *window_, settings_.bias), fitness);
}

} // namespace placedpar
