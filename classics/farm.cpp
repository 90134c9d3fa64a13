// A processor farm: the process csp.balancer gives tasks to processes csp.worker, and collects the results. If the
// parameter `deal` is "idle", the next task goes to any idle worker. If it is "turn", the workers get tasks in turn.

#include "classics/kinds.hpp"

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace placedpar {

namespace {

constexpr std::int64_t end_of_tasks = -1;

class Balancer {
public:
    explicit Balancer(const ProcessEnvironment& environment)
        : in_(environment.input<Packet>("in")), out_(environment.output<Packet>("out")),
          to_workers_(environment.outputs<Packet>("to_worker")),
          from_workers_(environment.inputs<Packet>("from_worker")), idle_(to_workers_.size(), true),
          by_turns_(environment.text("deal") == "turn"), left_to_deal_(environment.integer("count")),
          left_to_collect_(left_to_deal_) {}

    void run() {
        while (left_to_collect_ > 0)
            take(select(guards()));
        for (const auto& to_worker : to_workers_)
            to_worker.output({end_of_tasks});
    }

private:
    /// Returns the guards of the balancer's ALT. The first guard is the input of a task, with the condition that the
    /// worker next_worker() is idle. The other guards are the inputs of results, one from each worker.
    std::vector<Guard> guards() const {
        std::vector<Guard> guards{
            {left_to_deal_ > 0 && idle_[next_worker()] ? Guard::input : Guard::never, &in_.channel()}};
        for (const auto& from_worker : from_workers_)
            guards.push_back({Guard::input, &from_worker.channel()});
        return guards;
    }
    /// Returns the worker for the next task. For "turn" this is the worker whose turn it is; for "idle", the first idle
    /// worker, or worker 0 if none is idle.
    std::size_t next_worker() const {
        if (by_turns_)
            return turn_;
        auto found = std::ranges::find(idle_, true);
        return found == idle_.end() ? 0 : static_cast<std::size_t>(found - idle_.begin());
    }
    void take(std::size_t guard) {
        if (guard == 0)
            deal();
        else
            collect(guard - 1);
    }
    void deal() {
        std::size_t worker = next_worker();
        idle_[worker] = false;
        turn_ = (turn_ + 1) % idle_.size();
        --left_to_deal_;
        to_workers_[worker].output(in_.input());
    }
    void collect(std::size_t worker) {
        out_.output(from_workers_[worker].input());
        idle_[worker] = true;
        --left_to_collect_;
    }

    Input<Packet> in_;
    Output<Packet> out_;
    std::vector<Output<Packet>> to_workers_;
    std::vector<Input<Packet>> from_workers_;
    std::vector<bool> idle_;
    bool by_turns_;
    std::int64_t left_to_deal_, left_to_collect_;
    std::size_t turn_ = 0;
};

void balance(ProcessEnvironment& environment) { Balancer(environment).run(); }

/// Returns the cycles that a task takes. They do not depend on the worker.
std::int64_t cycles_of(const Packet& task, const ProcessEnvironment& environment) {
    RandomStream random = environment.random_stream("task " + std::to_string(task.number));
    double spread = environment.real("spread");
    double factor = 1 + spread * (2 * random.uniform() - 1);
    return static_cast<std::int64_t>(static_cast<double>(environment.integer("cycles")) * factor);
}

void work_on_tasks(ProcessEnvironment& environment) {
    auto from = environment.input<Packet>("in");
    auto to = environment.output<Packet>("out");
    std::int64_t tasks = 0;
    for (Packet task = from.input(); task.number != end_of_tasks; task = from.input()) {
        compute(Cycles{cycles_of(task, environment)});
        to.output(task);
        ++tasks;
    }
    environment.measure("tasks", static_cast<double>(tasks));
}

ProcessKind balancer() {
    using namespace description;
    return {.name = "csp.balancer",
            .about = "Deals out tasks to workers, passes on their results in order of arrival, and ends the "
                     "workers.",
            .ports = {packets_in("in", "tasks"), packets_out("out", "results"),
                      packets_out("to_worker", "an array: tasks, then an end message"),
                      packets_in("from_worker", "an array: results")},
            .parameters = {packet_count("tasks"),
                           text("deal", {.by_default = "idle", .choices = {"idle", "turn"}},
                                "idle: each task goes to an idle worker; turn: the workers get tasks in turn")},
            .body = balance};
}

ProcessKind worker() {
    using namespace description;
    return {.name = "csp.worker",
            .about = "Computes for each task and returns it as the result, until the end message arrives.",
            .ports = {packets_in("in", "tasks"), packets_out("out", "results")},
            .parameters = {packet_cycles("workload: mean number of cycles of a task"),
                           real("spread", {.by_default = 0, .least = 0, .most = 1},
                                "a task takes from 1 - spread to 1 + spread times the mean number of cycles")},
            .measurements = {{"tasks", "", "tasks done"}},
            .body = work_on_tasks};
}

} // namespace

std::vector<ProcessKind> farm_kinds() { return {balancer(), worker()}; }

} // namespace placedpar
