#include "gaprocs/processes/farm.hpp"

#include "runtime/alternation.hpp"
#include "runtime/kernel.hpp"
#include "runtime/parallel.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Deals out the individuals of a generation one by one, each to an idle slave or to the idle evaluator of the master.
/// The master's evaluator is a process of low priority on the master's processor.
class Farm::Dealer {
public:
    Dealer(std::size_t population, std::size_t window, std::size_t slaves, bool measurements_are_new)
        : population_(population), window_(window), lacks_measurements_(slaves, measurements_are_new) {}

    bool anything_left() const { return next_ < population_; }
    bool everything_in() const { return received_ == population_; }
    Share next() {
        std::size_t individual = next_++;
        return {individual * window_, (individual + 1) * window_, window_};
    }
    void received() { ++received_; }
    /// Returns whether the slave's next task must contain new measurements. Call this function once for each task,
    /// because afterwards the slave counts as having the measurements.
    bool owes_measurements(std::size_t slave) {
        bool owed = lacks_measurements_[slave];
        lacks_measurements_[slave] = false;
        return owed;
    }

private:
    std::size_t population_, window_;
    std::size_t next_ = 0, received_ = 0;
    std::vector<bool> lacks_measurements_;
};

namespace {

struct Done {};

} // namespace

void Farm::evaluate_on_demand(std::span<const Genome> population, std::vector<double>& fitness) {
    Dealer dealer(population.size(), window_->size(), settings_.slaves, measurements_are_new_);
    to_slaves_.during([&] { deal_to_all(dealer, population, fitness); });
}

void Farm::deal_to_all(Dealer& dealer, std::span<const Genome> population, std::vector<double>& fitness) {
    std::string self = Kernel::current()->running().path();
    Channel<Share> work("share of " + self);
    Channel<Done> done("share of " + self + " done");
    auto deal_out = [&] {
        deal_to_slaves(dealer, Task::Kind::evaluate, population);
        bool own_evaluator_works = true;
        auto deal_to_self = [&] {
            own_evaluator_works = dealer.anything_left();
            work.out().output(own_evaluator_works ? dealer.next() : Share{}); // an empty share ends evaluate_own_share
        };
        deal_to_self();
        std::vector<Guard> guards;
        for (const Input<Fitnesses>& from : from_slaves_)
            guards.push_back({Guard::input, &from.channel()});
        guards.push_back({Guard::input, &done.in().channel()});
        while (!dealer.everything_in()) {
            guards.back().kind = own_evaluator_works ? Guard::input : Guard::never;
            if (auto ready = select(guards); ready < from_slaves_.size()) {
                Fitnesses result = from_slaves_[ready].input();
                take(result, fitness);
                dealer.received();
                deal_to_slave(result.slave, dealer, Task::Kind::evaluate, population);
            } else {
                done.in().input();
                dealer.received();
                deal_to_self();
            }
        }
    };
    auto evaluate_own_share = [&] {
        own_evaluation.start();
        for (Share share = work.in().input(); share.evaluations() > 0; share = work.in().input()) {
            evaluate_own(share, population, fitness);
            done.out().output(Done{});
        }
        own_evaluation.stop();
    };
    pri_par(deal_out, evaluate_own_share);
}

void Farm::rehearse_on_demand(std::span<const Genome> population, std::vector<double>& fitness) {
    std::size_t own = population.size() / (settings_.slaves + 1);
    Dealer dealer(population.size() - own, window_->size(), settings_.slaves, true);
    to_slaves_.during([&] {
        deal_to_slaves(dealer, Task::Kind::rehearse, population);
        while (!dealer.everything_in()) {
            Fitnesses result = receive();
            take(result, fitness);
            dealer.received();
            deal_to_slave(result.slave, dealer, Task::Kind::rehearse, population);
        }
    });
}

/// Sends tasks to each slave until the slave has the largest allowed number of unanswered tasks.
void Farm::deal_to_slaves(Dealer& dealer, Task::Kind kind, std::span<const Genome> population) {
    for (std::size_t task = 0; task < settings_.tasks_under_way; ++task)
        for (std::size_t slave : in_turn_)
            deal_to_slave(slave, dealer, kind, population);
}

/// Sends the slave its next task. Does nothing if all individuals have been dealt out.
void Farm::deal_to_slave(std::size_t slave, Dealer& dealer, Task::Kind kind, std::span<const Genome> population) {
    if (!dealer.anything_left())
        return;
    Share next = dealer.next();
    send(make_task(kind, slave, next, population, dealer.owes_measurements(slave)));
}

} // namespace placedpar
