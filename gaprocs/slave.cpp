#include "gaprocs/kinds.hpp"

#include "gaprocs/messages.hpp"
#include "gaprocs/parameters.hpp"
#include "gaprocs/workload.hpp"
#include "netlist/environment.hpp"
#include "runtime/alternation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/processor.hpp"

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
          to_master_(environment.output<Fitnesses>("to_master")), beyond_(environment.integer("beyond")) {
        if (has_next_) {
            to_next_ = environment.output<Task>("to_next");
            from_next_ = environment.input<Fitnesses>("from_next");
        }
    }

    void run() {
        pri_par([this] { par([this] { pass_tasks_on(); }, [this] { pass_results_on(); }); }, [this] { evaluate(); });
    }

private:
    void pass_tasks_on() {
        for (bool ended = false; !ended;) {
            Task task = from_master_.input();
            ended = task.kind == Task::Kind::end;
            if (has_next_ && (ended || task.hops_left > 0)) {
                Task next = task;
                --next.hops_left;
                to_next_.output(std::move(next));
            }
            if (ended || task.hops_left == 0)
                own_tasks_.out().output({std::move(task)});
        }
    }

    void pass_results_on() {
        if (beyond_ > 0)
            while (pass_round_on()) {
            }
        else
            while (pass_next_result_on()) {
            }
        to_master_.output(end_of_results());
    }

    /// The results of all slaves beyond, the farthest first, and then the own one. False at the end.
    bool pass_round_on() {
        for (std::int64_t i = 0; i < beyond_; ++i) {
            Fitnesses result = from_next_.input();
            if (result.end) // and so does the own evaluator
                return pass_on(own_results_.in().input().message);
            pass_on(std::move(result));
        }
        return pass_on(own_results_.in().input().message);
    }

    /// Whichever result is ready. False at the end of all.
    bool pass_next_result_on() {
        auto own = when(
            own_open_, on(own_results_.in(), [&](InPlace<Fitnesses> r) { own_open_ = pass_on(std::move(r.message)); }));
        if (has_next_)
            alt(when(next_open_, on(from_next_, [&](Fitnesses r) { next_open_ = pass_on(std::move(r)); })), own);
        else
            alt(own);
        return own_open_ || next_open_;
    }

    bool pass_on(Fitnesses result) {
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
        result.bytes = static_cast<std::uint32_t>(task.strings.size()) * workload_.fitness_bytes;
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
    std::int64_t beyond_;
    bool own_open_ = true, next_open_ = has_next_;
    Channel<InPlace<Task>> own_tasks_{"own tasks"};
    Channel<InPlace<Fitnesses>> own_results_{"own results"};
    Window window_;
};

} // namespace

void run_slave(ProcessEnvironment& environment, const ProblemRegistry& problems) {
    Slave(environment, problems.find(environment.text("problem")).problem).run();
}

} // namespace placedpar
