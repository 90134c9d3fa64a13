#include "gaprocs/processes/search_process.hpp"

#include "gaprocs/processes/bias_point.hpp"
#include "gaprocs/processes/estimates.hpp"
#include "gaprocs/processes/farm.hpp"
#include "gaprocs/processes/island_exchange.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/search_progress.hpp"
#include "gaprocs/window.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/network/network.hpp"
#include "runtime/executive.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

Farm make_farm(const ProcessEnvironment& environment, const SearchProblem& problem, const Workload& workload) {
    return Farm(problem, workload, read_farm_settings(environment), environment.outputs<Task>("to_slaves"),
                environment.inputs<Fitnesses>("from_slaves"));
}

class SearchProcess {
public:
    /// `recoded` is the same object as `problem` if the process belongs to a pair of a coarse and a fine search;
    /// otherwise null.
    SearchProcess(ProcessEnvironment& environment, const SearchProblem& problem, RecodedProblem* recoded,
                  SearchObserver* observer, Checkpoints* checkpoints)
        : environment_(environment), problem_(problem), observer_(observer),
          settings_(read_search_settings(environment, problem)), workload_(read_workload(environment, problem)),
          from_host_(environment.input<HostMessage>("from_host")), to_host_(estimates_to("to_host")),
          to_analyst_(estimates_to("to_analyst")), farm_(make_farm(environment, problem, workload_)),
          has_slaves_(environment.connected("to_slaves")),
          rehearsals_(has_slaves_ ? environment.integer("rehearsals") : 0), window_(settings_.window),
          search_(problem.representation(), settings_, environment.random_stream(stream_name(environment))),
          progress_(search_, environment.process(), checkpoints) {
        if (environment.network().processes[environment.index()].kind == "ga.island")
            exchange_.emplace(environment, problem, settings_, workload_);
        if (recoded)
            bias_point_.emplace(environment, *recoded, workload_);
        if (observer)
            search_.listen(told_to(*observer, environment.process(), problem, now));
        if (progress_.best())
            values_of_best_ = problem_.decode(progress_.best()->genome);
    }

    void run() {
        if (exchange_)
            exchange_->beside_mail([this] { search_record(); });
        else
            search_record();
        for (Output<EstimateMessage>* output : {&to_host_, &to_analyst_})
            if (*output)
                end_estimates(*output);
        if (has_slaves_)
            leave_slaves();
        report();
    }

private:
    void search_record() {
        for (HostMessage message = from_host_.input(); !message.end; message = from_host_.input()) {
            window_.push(message.sample);
            ++samples_;
            if (!window_.ready() || (exchange_ && samples_ < exchange_->samples_to_begin()))
                continue;
            auto samples = window_.samples();
            farm_.measure(std::make_shared<const std::vector<Sample>>(samples.begin(), samples.end()));
            const bool full = samples.size() == settings_.window.length;
            for (std::size_t trial = 0; trial < settings_.window.trials; ++trial)
                if (!progress_.passes_over())
                    run_generation(full);
            if (to_host_)
                to_host_.output(estimate());
        }
        rate_.stop();
        progress_.require_passed(search_);
    }

    Output<EstimateMessage> estimates_to(const char* port) const {
        return environment_.connected(port) ? environment_.output<EstimateMessage>(port) : Output<EstimateMessage>();
    }

    /// Restarts the measurements of times at the first full window, because from then on all generations take the same
    /// time.
    void begin_timing() {
        farm_.forget_times();
        execution_ = operators_ = Stopwatch{};
        generations_before_timing_ = search_.generation();
        rate_.start();
    }

    void run_generation(bool full_window) {
        if (full_window && !std::exchange(timing_, true))
            begin_timing();
        execution_.start();
        if (bias_point_)
            bias_point_->before_generation();
        progress_.note_population(search_);
        std::vector<double> fitness = farm_.evaluate(search_.population());
        migrations_.clear();
        if (exchange_ && exchange_->is_due(search_.generation() + 1))
            migrations_ = exchange_->exchange(search_, fitness, window_.samples());
        operators_.start();
        compute(static_cast<std::int64_t>(fitness.size()) * workload_.genetic_operators);
        accept_and_breed(search_, fitness, migrations_, exchange_ ? exchange_->acceptance() : Acceptance());
        // Decodes the parameters now, because the bias point of a fine search moves later.
        if (progress_.note_best(search_))
            values_of_best_ = problem_.decode(search_.best().genome);
        operators_.stop();
        if (bias_point_)
            bias_point_->after_generation(search_.best().genome);
        if (to_analyst_ && exchange_->reports_after(search_.generation()))
            to_analyst_.output(estimate());
        execution_.stop();
        if (observer_)
            tell_migrations();
        progress_.keep(search_);
    }

    EstimateMessage estimate() const {
        EstimateMessage estimate;
        estimate.generation = search_.generation();
        estimate.samples = samples_;
        estimate.best = best_known();
        estimate.bytes = message_bytes(1, workload_.string_bytes + workload_.fitness_bytes);
        return estimate;
    }

    static void end_estimates(Output<EstimateMessage>& output) {
        EstimateMessage end;
        end.end = true;
        output.output(std::move(end));
    }

    void tell_migrations() const {
        for (const Migration& each : migrations_)
            observer_->observe({exchange_->name_of(each.from), environment_.process(), search_.generation(), now(),
                                each.individual.fitness, each.place.has_value()});
    }

    /// Measures C_time2, the communication time of a generation, and then ends the slaves. The measurement begins after
    /// all other work of the machine, so it does not change the times of this work.
    void leave_slaves() {
        wait_until_work_is_over();
        if (timing_ && rehearsals_ > 0)
            rehearse();
        farm_.end();
    }

    void rehearse() {
        rehearsal_.start();
        for (std::int64_t i = 0; i < rehearsals_; ++i)
            farm_.rehearse(search_.population());
        rehearsal_.stop();
    }

    void report() {
        if (timing_)
            report_times();
        environment_.measure("generations", static_cast<double>(search_.generation()));
        if (timing_)
            report_rate();
        environment_.measure("populations", fmt::format("{:016x}", progress_.populations()));
        if (search_.generation() > 0)
            report_best_known();
    }

    /// Reports the mean times of generations with a full window.
    void report_times() {
        environment_.measure("T_exe", execution_.mean_milliseconds(), "ms");
        environment_.measure("T_sr", farm_.send_to_receive.mean_milliseconds(), "ms");
        environment_.measure("P_time2", farm_.own_evaluation.mean_milliseconds(), "ms");
        if (rehearsals_ > 0)
            environment_.measure("C_time2", rehearsal_.mean_milliseconds() / static_cast<double>(rehearsals_), "ms");
        else if (!has_slaves_)
            environment_.measure("C_time2", 0, "ms");
        environment_.measure("S_time2", operators_.mean_milliseconds(), "ms");
    }

    /// Reports the generations per second. Reports nothing on a workstation, where generations take no simulated time.
    void report_rate() {
        auto timed = static_cast<double>(search_.generation() - generations_before_timing_);
        if (double milliseconds = rate_.mean_milliseconds(); milliseconds > 0)
            environment_.measure("generations_per_second", timed / milliseconds * 1000, "1/s");
    }

    /// Returns the best individual. If the problem has an objective, this is the best of all generations; otherwise it
    /// is the best of the last generation, which was evaluated with the newest measurements.
    const Individual& best_known() const { return problem_.objective() ? *progress_.best() : search_.best(); }

    void report_best_known() {
        measure_individual(environment_, problem_, best_known(),
                           problem_.objective() ? values_of_best_ : problem_.decode(best_known().genome));
    }

    ProcessEnvironment& environment_;
    const SearchProblem& problem_;
    SearchObserver* observer_; ///< null: no observer
    SearchSettings settings_;
    Workload workload_;
    Input<HostMessage> from_host_;
    Output<EstimateMessage> to_host_, to_analyst_; ///< not connected if the process's port is not connected
    Farm farm_;
    bool has_slaves_;
    std::int64_t rehearsals_;
    std::optional<IslandExchange> exchange_;
    std::optional<BiasPointEnd> bias_point_; ///< only if the process belongs to a pair

    std::size_t samples_ = 0; ///< number of samples received
    SlidingWindow window_;
    Search search_;
    SearchProgress progress_;
    std::vector<double> values_of_best_; ///< parameters of the fittest individual of all generations
    std::vector<Migration> migrations_;  ///< immigrants of this generation; Migration::place is set when the generation
                                         ///< is bred

    bool timing_ = false;
    std::uint64_t generations_before_timing_ = 0;
    Stopwatch execution_, operators_, rehearsal_, rate_;
};

void run_search(ProcessEnvironment& environment, const ProblemRegistry& problems, SearchObserver* observer,
                Checkpoints* checkpoints) {
    const RecordedProblem& recorded = problems.find(environment.text("problem"));
    const ProcessInstance& process = environment.network().processes[environment.index()];
    std::shared_ptr<RecodedProblem> recoded;
    if (breeds_recoded(process))
        recoded = std::make_shared<RecodedProblem>(*recorded.problem(), read_recoding(process));
    std::shared_ptr<const SearchProblem> problem = recoded;
    if (!recoded)
        problem = recorded.problem()->coded(read_coding(environment));
    if (!problem->objective())
        read_search_settings(environment, *problem).window.validate_for(recorded.samples());
    SearchProcess(environment, *problem, recoded.get(), observer, checkpoints).run();
}

} // namespace

ProcessKind searching(ProcessKind described, const ProblemRegistry& problems, SearchObserver* observer,
                      Checkpoints* checkpoints) {
    described.body = [&problems, observer, checkpoints](ProcessEnvironment& environment) {
        run_search(environment, problems, observer, checkpoints);
    };
    described.is_determinate = always;
    described.check = [&problems](const Network& network, std::size_t process) {
        return check_search(network, process, problems);
    };
    return described;
}

} // namespace placedpar
