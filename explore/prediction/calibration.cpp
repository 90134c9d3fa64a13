#include "explore/prediction/calibration.hpp"

#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "native/native_run.hpp"
#include "native/ping_pong.hpp"
#include "netlist/read.hpp"
#include "text/user_error.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <fstream>
#include <memory>
#include <optional>
#include <sched.h>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t individuals = 20; // in each search that is measured

/// The process kinds that one thread uses, with the problems to which the kinds refer. Each thread has its own.
struct KindsToMeasure {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
};

RunReport measure_natively(const Network& network, std::size_t threads) {
    NativeSettings settings;
    settings.threads = threads;
    settings.make_catalogue = []() -> std::shared_ptr<const Catalogue> {
        const auto kinds = std::make_shared<KindsToMeasure>();
        return {kinds, &kinds->catalogue};
    };
    return run_natively(network, settings);
}

Network network_to_measure(const std::string& text, const Catalogue& catalogue) {
    ReadResult read = read_netlist_text(text, catalogue);
    if (!read.network)
        throw UserError(render(read));
    return std::move(*read.network);
}

/// Returns a netlist with a search on one core. In a simulated run, each error takes 1000 cycles.
std::string search_of(const std::string& problem, std::size_t generations) {
    return fmt::format("core (clock = 1000M) c[2]; shared_memory m;\n"
                       "rep i = 0 for 2 connect c[i].bus[0] to m.slot[i + 1];\n"
                       "process host, master; use \"ga.host\" for host; use \"ga.master\" for master;\n"
                       "host (problem = \"{0}\"{1}); master (problem = \"{0}\", population = {2}, "
                       "cycles_per_error = 1000);\n"
                       "connect host.to_masters[0] to master.from_host; place host on c[0]; place master on c[0];\n",
                       problem, generations > 0 ? fmt::format(", generations = {}", generations) : "", individuals);
}

/// Returns a farm whose master and slave are on one core.
std::string farm_of(std::size_t population) {
    return fmt::format(
        "core c; process host, master, slave;\n"
        "use \"ga.host\" for host; use \"ga.master\" for master; use \"ga.slave\" for slave;\n"
        "master (population = {}, own_share = 0.0, rehearsals = 1000);\n"
        "connect host.to_masters[0] to master.from_host; connect master.to_slaves to slave.from_master;\n"
        "connect slave.to_master to master.from_slaves; place host on c; place master on c; place slave on c;\n",
        population);
}

/// Lets this thread, and the threads that it starts, run on every core, because mpirun binds each rank to one core.
class OnEveryCore {
public:
    OnEveryCore() {
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t all;
        std::memset(&all, 0xff, sizeof all);
        sched_setaffinity(0, sizeof all, &all);
    }
    ~OnEveryCore() { sched_setaffinity(0, sizeof before_, &before_); }
    OnEveryCore(const OnEveryCore&) = delete;
    OnEveryCore& operator=(const OnEveryCore&) = delete;

private:
    cpu_set_t before_{};
};

class Calibrator {
public:
    explicit Calibrator(const CalibrationSettings& settings) : settings_(settings) {}

    Calibration run() {
        Calibration result;
        result.repetitions = settings_.repetitions;
        std::optional<OnEveryCore> unbound; // while the threads are measured
        if (settings_.ranks) {
            measure_ranks(result);
            unbound.emplace();
        }
        measure_threads(result);
        result.string = repeat("individuals in messages", [this] { return string_nanoseconds(); });
        for (const std::string& problem : settings_.problems)
            if (!settings_.is_interrupted())
                result.problems.push_back(cost_of_problem(problem));
        if (settings_.is_interrupted())
            result.problems.clear();
        return result;
    }

private:
    static constexpr long often = 20'000, seldom = 100; // numbers of messages

    template <class Measure>
    MeasuredCost repeat(const std::string& what, Measure measure) {
        settings_.progress(what);
        std::vector<double> values;
        for (std::size_t i = 0; i < settings_.repetitions && !settings_.is_interrupted(); ++i)
            values.push_back(measure());
        return settings_.is_interrupted() ? MeasuredCost{} : cost_of(std::move(values));
    }

    /// `switches(n)` measures a switch n times, and `matches` measures a message there and back; both return the time
    /// in nanoseconds.
    template <class Switches, class Matches>
    MessageCosts measure_messages(const std::string& where, Switches switches, Matches matches) {
        constexpr std::size_t large = 256 * 1024;
        return {.switching = repeat("switches of " + where, [&] { return switches(often); }),
                .there_and_back = repeat("messages inside one of the " + where,
                                         [&] { return matches({.kernels = 1, .times = often}); }),
                .across = repeat("messages between " + where, [&] { return matches({.times = often}); }),
                .kilobyte = repeat("large messages between " + where, [&] {
                    const auto one_way = [&](std::size_t kernels) {
                        return matches({.kernels = kernels, .times = seldom, .bytes = large}) / 2;
                    };
                    return std::max((one_way(2) - one_way(1)) / (large / 1024.0), 0.0);
                })};
    }

    void measure_threads(Calibration& result) {
        static constexpr Time pause = std::chrono::microseconds(200); // far longer than a thread polls before it sleeps
        result.threads = measure_messages("threads", native::nanoseconds_of_switch, native::nanoseconds_there_and_back);
        result.across_asleep = repeat("messages to threads that sleep", [] {
            return native::nanoseconds_there_and_back({.times = seldom, .pause = pause});
        });
    }

    void measure_ranks(Calibration& result) {
        native::RankMatches matches(*settings_.ranks);
        result.ranks = measure_messages(
            "ranks", [&](long times) { return matches.nanoseconds_of_switch(times); },
            [&](const native::PingPong& match) { return matches.nanoseconds_there_and_back(match); });
        result.oversleeping = repeat("pauses of ranks", native::nanoseconds_of_oversleeping);
    }

    double string_nanoseconds() const {
        constexpr std::size_t few = 20, many = 220;
        const auto rehearsal = [&](std::size_t population) {
            const Network network = network_to_measure(farm_of(population), kinds_.catalogue);
            return 1e6 * measure_natively(network, 1).measured("master", "C_time2");
        };
        return std::max((rehearsal(many) - rehearsal(few)) / static_cast<double>(many - few), 0.0);
    }

    /// Returns the number of generations of a search that takes about 20 ms. Returns 0 for a problem with a record.
    std::size_t generations_for(const std::string& problem) const {
        if (!kinds_.problems.find(problem).problem()->objective())
            return 0;
        constexpr double aim_ms = 20, most = 500;
        const Network network = network_to_measure(search_of(problem, 2), kinds_.catalogue);
        const double once_ms = measure_natively(network, 1).measured("master", "T_exe");
        return static_cast<std::size_t>(std::clamp(aim_ms / std::max(once_ms, 1e-6), 2.0, most));
    }

    ProblemCost cost_of_problem(const std::string& problem) {
        settings_.progress(fmt::format("\"{}\"", problem));
        const Network network = network_to_measure(search_of(problem, generations_for(problem)), kinds_.catalogue);
        const double evaluation_ms = run_netlist(network, kinds_.catalogue, {}).measured("master", "P_time2");
        const double errors = evaluation_ms * 1000; // an error takes 1000 cycles of 1 ns
        std::vector<double> error, rest;
        for (std::size_t i = 0; i < settings_.repetitions && !settings_.is_interrupted(); ++i) {
            const RunReport report = measure_natively(network, 1);
            const double own_ms = report.measured("master", "P_time2");
            error.push_back(1e6 * own_ms / errors);
            rest.push_back(1e6 * (report.measured("master", "T_exe") - own_ms) / individuals);
        }
        return settings_.is_interrupted() ? ProblemCost{problem, {}, {}}
                                          : ProblemCost{problem, cost_of(std::move(error)), cost_of(std::move(rest))};
    }

    const CalibrationSettings& settings_;
    KindsToMeasure kinds_;
};

/// Returns the processor's name as the operating system states it.
std::string name_of_processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (const std::size_t colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    return "unknown processor";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

} // namespace

MeasuredCost cost_of(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    // The probability that the median is less than value number k or greater than value number n - k - 1 is twice the
    // binomial sum up to k.
    std::size_t k = 0;
    double term = std::pow(0.5, static_cast<double>(n)), below = term;
    for (; k + 1 < n / 2; ++k) {
        term *= static_cast<double>(n - k) / static_cast<double>(k + 1);
        if (2 * (below + term) > 0.05)
            break;
        below += term;
    }
    return {(values[n / 2] + values[(n - 1) / 2]) / 2, values[k], values[n - 1 - k]};
}

Calibration measure_computer(const CalibrationSettings& settings) {
    Calibration result = Calibrator(settings).run();
    result.processor = name_of_processor();
    result.date = today();
    return result;
}

void help_to_measure(Ranks& ranks) { native::play_with_rank_zero(ranks); }

} // namespace placedpar
