#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/pipeline_check.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/slave_routes.hpp"
#include "gaprocs/processes/slave_tree.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/alternation.hpp"
#include "runtime/parallel.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// Consists of two processes of high priority: one passes the masters' tasks on to the slaves, the other passes the
/// slaves' results on to the masters. A slave may receive tasks from several masters; it queues the tasks and answers
/// them in turn.
class Pipeline {
public:
    explicit Pipeline(const ProcessEnvironment& environment)
        : from_masters_(environment.inputs<Task>("from_masters")),
          to_masters_(environment.outputs<Fitnesses>("to_masters")), to_slaves_(environment.outputs<Task>("to_slaves")),
          from_slaves_(environment.inputs<Fitnesses>("from_slaves")), routes_(read_routes(environment)),
          slaves_(follow_slaves(environment.network(), environment.index()).slaves.size()) {}

    void run() {
        run_in_parallel(
            {{[this] { pass_tasks_on(); }, Priority::high}, {[this] { pass_results_on(); }, Priority::high}},
            SourceLocation::current());
    }

private:
    void pass_tasks_on() {
        auto open = guards_of(from_masters_);
        for (std::size_t left = open.size(); left > 0;)
            if (std::size_t master = select(open); !pass_generation_on(master)) {
                open[master].kind = Guard::never;
                --left;
            }
        for (const Output<Task>& to : to_slaves_)
            to.output(Task{});
    }

    /// Passes on the tasks of one generation of a master, one task for each slave. During this time, other masters have
    /// to wait. Returns false if the master has ended.
    bool pass_generation_on(std::size_t master) {
        for (std::size_t sent = 0; sent < slaves_; ++sent) {
            Task task = from_masters_[master].input();
            if (task.kind == Task::Kind::end)
                return false;
            auto [channel, address] = routes_.to(task.address);
            task.address = address;
            task.master = master;
            task.tasks_under_way = from_masters_.size();
            to_slaves_[channel].output(std::move(task));
        }
        return true;
    }

    void pass_results_on() {
        auto open = guards_of(from_slaves_);
        for (std::size_t left = open.size(); left > 0;) {
            std::size_t channel = select(open);
            Fitnesses result = from_slaves_[channel].input();
            if (result.end) {
                open[channel].kind = Guard::never;
                --left;
            } else
                to_masters_[result.master].output(std::move(result));
        }
        Fitnesses end;
        end.end = true;
        for (const Output<Fitnesses>& to : to_masters_)
            to.output(end);
    }

    template <class T>
    static std::vector<Guard> guards_of(const std::vector<Input<T>>& inputs) {
        std::vector<Guard> guards;
        for (const Input<T>& input : inputs)
            guards.push_back({Guard::input, &input.channel()});
        return guards;
    }

    std::vector<Input<Task>> from_masters_;
    std::vector<Output<Fitnesses>> to_masters_;
    std::vector<Output<Task>> to_slaves_;
    std::vector<Input<Fitnesses>> from_slaves_;
    SlaveRoutes routes_;
    std::size_t slaves_;
};

} // namespace

ProcessKind pipeline_kind(const ProblemRegistry&) {
    using namespace search_description;
    using namespace description;
    return {.name = "ga.pipeline",
            .about = "Lets masters share the same slaves (thesis, Figure 4.5): while one master breeds, the slaves "
                     "evaluate the population of another. Each master makes the same generations as it would with "
                     "slaves of its own.",
            .ports = {input<Task>("from_masters", "task", "an array: one end for each master's to_slaves"),
                      output<Fitnesses>("to_masters", "fitnesses",
                                        "an array: one end for each master's from_slaves, in the same order"),
                      to_slaves(), from_slaves()},
            .body = [](ProcessEnvironment& environment) { Pipeline(environment).run(); },
            .together = {{"to_slaves", "from_slaves"}},
            .check = check_pipeline};
}

} // namespace placedpar
