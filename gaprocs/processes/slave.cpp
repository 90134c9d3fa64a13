#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/slave_routes.hpp"
#include "gaprocs/processes/workload.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"

#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

struct NextTask {};

/// A slave of algorithm A: three processes on one processor. One process of high priority passes tasks on to the slaves
/// behind, another passes results on towards the master. A process of low priority evaluates. If the slave may have
/// several unanswered tasks, a fourth process queues these tasks, so that tasks for the slaves behind never wait for
/// the evaluation.
class Slave {
public:
    Slave(const ProcessEnvironment& environment, std::shared_ptr<const SearchProblem> problem)
        : problem_(std::move(problem)), workload_(read_slave_workload(environment)),
          from_master_(environment.input<Task>("from_master")), to_master_(environment.output<Fitnesses>("to_master")),
          to_slaves_(environment.outputs<Task>("to_slaves")),
          from_slaves_(environment.inputs<Fitnesses>("from_slaves")), routes_(read_routes(environment)),
          own_tasks_("task of " + environment.process()), kept_tasks_("kept task of " + environment.process()),
          next_task_("next task of " + environment.process()), own_results_("result of " + environment.process()) {}

    /// Reads the order of the results and the largest number of unanswered tasks from the first task, then runs the
    /// slave.
    void run() {
        Task first = from_master_.input();
        results_in_order_ = first.results_in_order;
        keeps_tasks_ = first.tasks_under_way > 1;
        auto pass_tasks = [&] { pass_tasks_on(std::move(first)); };
        auto pass_results = [this] { pass_results_on(); };
        auto pass_on = [&] {
            if (keeps_tasks_)
                par(pass_tasks, pass_results, [this] { keep_tasks(); });
            else
                par(pass_tasks, pass_results);
        };
        pri_par(pass_on, [this] { evaluate(); });
    }

private:
    void pass_tasks_on(Task task) {
        while (pass_task_on(std::move(task)))
            task = from_master_.input();
    }

    /// Passes a task on to a slave behind this slave, or to this slave's own evaluation. Passes an end message on to
    /// all slaves behind and to this slave's own evaluation, and then returns false.
    bool pass_task_on(Task task) {
        bool ended = task.kind == Task::Kind::end;
        if (ended)
            for (const Output<Task>& to : to_slaves_)
                to.output(task);
        else if (task.address > 0) {
            auto [channel, address] = routes_.to(task.address - 1);
            task.address = address;
            to_slaves_[channel].output(std::move(task));
            return true;
        }
        (keeps_tasks_ ? kept_tasks_ : own_tasks_).out().output({std::move(task)});
        return !ended;
    }

    /// Keeps the tasks that this slave evaluates in a queue: first in, first out.
    void keep_tasks() {
        std::deque<Task> kept;
        bool ended = false;
        while (!ended || !kept.empty())
            alt(when(!ended, on(kept_tasks_.in(),
                                [&](InPlace<Task> task) {
                                    ended = task.message.kind == Task::Kind::end;
                                    kept.push_back(std::move(task.message));
                                })),
                when(!kept.empty(), on(next_task_.in(), [&](NextTask) {
                    own_tasks_.out().output({std::move(kept.front())});
                    kept.pop_front();
                })));
    }

    void pass_results_on() {
        if (results_in_order_ && !from_slaves_.empty())
            while (pass_round_on()) {
            }
        else
            pass_results_on_as_they_are_ready();
        to_master_.output(end_of_results());
    }

    /// Passes on the results of one generation: first the results of the slaves behind (channel by channel, each
    /// beginning with the farthest slave), then this slave's own result. Returns false at the end message.
    bool pass_round_on() {
        for (const Input<Fitnesses>& from : from_slaves_)
            for (bool last = false; !last;) {
                Fitnesses result = from.input();
                last = result.end || result.hops == 0; // the nearest slave's result is the last of a generation
                pass_on(std::move(result));
            }
        return send(own_results_.in().input().message);
    }

    void pass_results_on_as_they_are_ready() {
        std::vector<Guard> open;
        for (const Input<Fitnesses>& from : from_slaves_)
            open.push_back({Guard::input, &from.channel()});
        open.push_back({Guard::input, &own_results_.in().channel()});
        for (std::size_t left = open.size(); left > 0;) {
            std::size_t ready = select(open);
            bool own = ready == from_slaves_.size();
            if (own ? send(own_results_.in().input().message) : pass_on(from_slaves_[ready].input()))
                continue;
            open[ready].kind = Guard::never;
            --left;
        }
    }

    /// Passes the result on towards the master. Returns false if the result is the end message.
    bool pass_on(Fitnesses result) {
        ++result.hops;
        return send(std::move(result));
    }

    bool send(Fitnesses result) {
        if (result.end)
            return false;
        to_master_.output(std::move(result));
        return true;
    }

    Task next_task() {
        if (keeps_tasks_)
            next_task_.out().output({});
        return own_tasks_.in().input().message;
    }

    void evaluate() {
        for (Task task = next_task(); task.kind != Task::Kind::end; task = next_task())
            own_results_.out().output({answer(task)});
        own_results_.out().output({end_of_results()});
    }

    static Fitnesses end_of_results() {
        Fitnesses end;
        end.end = true;
        return end;
    }

    Fitnesses answer(const Task& task) {
        compute(block_move(task.bytes)); // unpacking
        Window& window = windows_[task.master];
        if (task.window)
            window = task.window;
        Fitnesses result;
        result.slave = task.slave;
        result.master = task.master;
        result.share = task.share;
        if (task.kind == Task::Kind::evaluate) {
            compute(static_cast<std::int64_t>(task.share.evaluations()) * workload_.error_evaluation);
            if (task.coding != problem_->coding())
                problem_ = problem_->coded(task.coding);
            result.terms = evaluate_share(*problem_, task.share, task.strings, *window, task.bias);
        }
        result.bytes = message_bytes(task.strings.size(), workload_.fitness_bytes);
        compute(block_move(result.bytes)); // packing
        return result;
    }

    std::shared_ptr<const SearchProblem> problem_;
    Workload workload_;
    Input<Task> from_master_;
    Output<Fitnesses> to_master_;
    std::vector<Output<Task>> to_slaves_;
    std::vector<Input<Fitnesses>> from_slaves_;
    SlaveRoutes routes_;
    bool results_in_order_ = false, keeps_tasks_ = false;
    Channel<InPlace<Task>> own_tasks_, kept_tasks_;
    Channel<NextTask> next_task_;
    Channel<InPlace<Fitnesses>> own_results_;
    std::map<std::size_t, Window> windows_; ///< key: number of the master
};

void run_slave(ProcessEnvironment& environment, const ProblemRegistry& problems) {
    Slave(environment, problems.find(environment.text("problem")).problem()).run();
}

} // namespace

ProcessKind slave_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    using namespace description;
    return {.name = "ga.slave",
            .about =
                "A slave of algorithm A: evaluates its share and passes on the messages of the slaves beyond it. The "
                "connections make a chain, a star or any other tree of a master and its slaves.",
            .ports = {input<Task>("from_master", "task", "from the master, or from the slave before this one"),
                      output<Fitnesses>("to_master", "fitnesses", "to the master, or to the slave before this one"),
                      formerly("to_next", to_slaves()), formerly("from_next", from_slaves())},
            .parameters = {problem(), cycles_per_error(), fitness_bytes()},
            .body = [&problems](ProcessEnvironment& environment) { run_slave(environment, problems); },
            .together = {{"to_slaves", "from_slaves"}},
            .check = [&problems](const Network& network,
                                 std::size_t process) { return check_slave(network, process, problems); },
            .is_determinate = always};
}

} // namespace placedpar
