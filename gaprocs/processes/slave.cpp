#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/workload.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"

#include <memory>
#include <utility>

namespace placedpar {

namespace {

/// A slave of algorithm A: three processes on one processor. Two of high priority pass messages on, tasks
/// away from the master and results towards it; one of low priority evaluates.
class Slave {
public:
    Slave(const ProcessEnvironment& environment, std::shared_ptr<const SearchProblem> problem)
        : problem_(std::move(problem)), workload_(read_slave_workload(environment)),
          has_next_(environment.connected("to_next")), from_master_(environment.input<Task>("from_master")),
          to_master_(environment.output<Fitnesses>("to_master")), own_tasks_("task of " + environment.process()),
          own_results_("result of " + environment.process()) {
        if (has_next_) {
            to_next_ = environment.output<Task>("to_next");
            from_next_ = environment.input<Fitnesses>("from_next");
        }
    }

    /// The first task says in which order results are to be passed on.
    void run() {
        Task first = from_master_.input();
        results_in_order_ = first.results_in_order;
        pri_par([&] { par([&] { pass_tasks_on(std::move(first)); }, [this] { pass_results_on(); }); },
                [this] { evaluate(); });
    }

private:
    void pass_tasks_on(Task task) {
        while (pass_task_on(std::move(task)))
            task = from_master_.input();
    }

    /// To the next slave, to this slave's evaluator, or to both. False at the end.
    bool pass_task_on(Task task) {
        bool ended = task.kind == Task::Kind::end;
        if (has_next_ && (ended || task.hops_left > 0)) {
            Task next = task;
            --next.hops_left;
            to_next_.output(std::move(next));
        }
        if (ended || task.hops_left == 0)
            own_tasks_.out().output({std::move(task)});
        return !ended;
    }

    void pass_results_on() {
        if (results_in_order_ && has_next_)
            while (pass_round_on()) {
            }
        else
            while (pass_next_result_on()) {
            }
        to_master_.output(end_of_results());
    }

    /// The results of all slaves beyond, the farthest first, and then this slave's. False at the end.
    bool pass_round_on() {
        for (bool last = false; !last;) {
            Fitnesses result = from_next_.input();
            last = result.end || result.hops == 0; // a round ends with the next slave's own result
            pass_on(std::move(result));
        }
        return send(own_results_.in().input().message);
    }

    /// One result, as soon as any is ready. False when all have ended.
    bool pass_next_result_on() {
        auto own = when(own_open_,
                        on(own_results_.in(), [&](InPlace<Fitnesses> r) { own_open_ = send(std::move(r.message)); }));
        if (has_next_)
            alt(when(next_open_, on(from_next_, [&](Fitnesses r) { next_open_ = pass_on(std::move(r)); })), own);
        else
            alt(own);
        return own_open_ || next_open_;
    }

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

    void evaluate() {
        for (Task task = own_tasks_.in().input().message; task.kind != Task::Kind::end;
             task = own_tasks_.in().input().message)
            own_results_.out().output({answer(task)});
        own_results_.out().output({end_of_results()});
    }

    static Fitnesses end_of_results() {
        Fitnesses end;
        end.end = true;
        return end;
    }

    Fitnesses answer(const Task& task) {
        compute(block_move(task.bytes)); // unpack
        if (task.window)
            window_ = task.window;
        Fitnesses result;
        result.slave = task.slave;
        result.share = task.share;
        if (task.kind == Task::Kind::evaluate) {
            compute(static_cast<std::int64_t>(task.share.evaluations()) * workload_.error_evaluation);
            if (task.coding != problem_->coding())
                problem_ = problem_->coded(task.coding);
            result.terms = evaluate_share(*problem_, task.share, task.strings, *window_, task.bias);
        }
        result.bytes = message_bytes(task.strings.size(), workload_.fitness_bytes);
        compute(block_move(result.bytes)); // pack
        return result;
    }

    std::shared_ptr<const SearchProblem> problem_;
    Workload workload_;
    bool has_next_;
    Input<Task> from_master_;
    Output<Fitnesses> to_master_;
    Output<Task> to_next_;
    Input<Fitnesses> from_next_;
    bool results_in_order_ = false;
    bool own_open_ = true, next_open_ = has_next_;
    Channel<InPlace<Task>> own_tasks_;
    Channel<InPlace<Fitnesses>> own_results_;
    Window window_;
};

void run_slave(ProcessEnvironment& environment, const ProblemRegistry& problems) {
    Slave(environment, problems.find(environment.text("problem")).problem()).run();
}

} // namespace

ProcessKind slave_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    using namespace description;
    return {.name = "ga.slave",
            .about = "A slave of algorithm A, one of a chain: evaluates its share and passes on what is for the slaves "
                     "beyond it.",
            .ports = {input<Task>("from_master", "task", "from the master or the slave before"),
                      output<Fitnesses>("to_master", "fitnesses", "to the master or the slave before"),
                      optional(output<Task>("to_next", "task", "to the slave beyond")),
                      optional(input<Fitnesses>("from_next", "fitnesses", "from the slave beyond"))},
            .parameters = {problem(), cycles_per_error(), fitness_bytes()},
            .body = [&problems](ProcessEnvironment& environment) { run_slave(environment, problems); },
            .together = {{"to_next", "from_next"}},
            .check = [&problems](const Network& network,
                                 std::size_t process) { return check_slave(network, process, problems); }};
}

} // namespace placedpar
