#include "experiments/kit/experiment_runs.hpp"
#include "experiments/kit/printing_run.hpp"
#include "explore/problems.hpp"
#include "gaprocs/traditional.hpp"
#include "runtime/fingerprint.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

// This experiment compares programs in occam, compiled here, with the same programs compiled by INMOS's compiler of
// 1991, and with the programs of the thesis.

namespace placedpar {

namespace {

constexpr const char* inmos = "INMOS";

struct WayToCompile {
    const char* column;
    occam::CodeOptions options;
};
constexpr std::array ways_to_compile{
    WayToCompile{"mode halt", {.model = transputer::Model::t800}},
    WayToCompile{"unchecked", {.model = transputer::Model::t800, .range_checks = false, .run_time_checks = false}},
    WayToCompile{"mode stop", {.model = transputer::Model::t800, .mode = occam::ErrorMode::stop}},
};

/// A program, the result that it prints, and its times when compiled by INMOS's occam compiler 2.01 with each of the
/// three sets of options. The times are in ticks of 64 us, measured on the emulated T800 with all memory on the chip.
struct ProgramOfInmos {
    const char* name;
    double result;
    std::array<double, ways_to_compile.size()> ticks;
};
constexpr std::array programs_of_inmos{
    ProgramOfInmos{"ring-seq", 20015, {3453, 3453, 4015}},        ProgramOfInmos{"ring-par", 20015, {4281, 4281, 4844}},
    ProgramOfInmos{"sieve", 1028, {9383, 8207, 11345}},           ProgramOfInmos{"matrix32", 1290, {5061, 4936, 5831}},
    ProgramOfInmos{"two-clients", 150015000, {3219, 3219, 3610}},
};

/// Returns the ticks that a program prints after its result. Throws UserError if the result is wrong.
double ticks_of(const ProgramOfInmos& program, const WayToCompile& way, const ReplayContext& context,
                Fingerprint& fingerprint) {
    context.progress(fmt::format("{}, {}", program.name, way.column));
    const PrintedRun run = run_occam(context.examples / "occam/beside-inmos" / fmt::format("{}.occ", program.name),
                                     way.options, 1, context);
    fingerprint.mix(run.fingerprint);
    const std::vector<double> numbers = run.numbers();
    if (numbers.size() != 2 || numbers[0] != program.result)
        throw UserError(fmt::format("{} should print the result {} and its ticks, but printed\n{}", program.name,
                                    program.result, run.text));
    return numbers[1];
}

Cell cell_of_ticks(const ProgramOfInmos& program, std::size_t way, double ticks) {
    Cell cell = compared_cell(program.name, ways_to_compile[way].column, "ticks", program.ticks[way], ticks, 0);
    cell.tolerance_percent = 6;
    return cell;
}

Comparison compare_with_inmos(const ReplayContext& context, Fingerprint& fingerprint) {
    Comparison table{.name = "time beside that of INMOS's compiler of 1991", .against = inmos, .judged = true};
    std::array<double, ways_to_compile.size()> deviations{};
    for (const ProgramOfInmos& program : programs_of_inmos)
        for (std::size_t way = 0; way < ways_to_compile.size(); ++way) {
            const double ticks = ticks_of(program, ways_to_compile[way], context, fingerprint);
            table.add(cell_of_ticks(program, way, ticks));
            deviations[way] += 100 * (ticks / program.ticks[way] - 1) / programs_of_inmos.size();
        }
    for (std::size_t way = 0; way < ways_to_compile.size(); ++way)
        table.add(judged_cell("mean difference", ways_to_compile[way].column, "%", 0, deviations[way], 3, 1));
    table.notes = "The code of both compilers ran on the emulated T800 with all memory on the chip; a tick is 64 us.\n";
    return table;
}

// The thesis's programs

constexpr std::array memories{std::pair{"1 cycle", 1}, std::pair{"3 cycles", 3}, std::pair{"5 cycles", 5}};

constexpr std::array ways_to_evaluate{"REAL64, orifices known", "REAL32, orifices known", "REAL64, as printed",
                                      "REAL64, with slopes"};

/// Returns the sum of the fitness that the C++ library computes for the strings and the window of boom.occ, for
/// comparison with the program in occam.
double fitness_in_cpp() {
    const ProblemRegistry problems = known_problems(1);
    const RecordedProblem& boom = problems.find("boom");
    std::vector<Genome> strings;
    for (std::uint64_t code = 4; code < 960; code += 8)
        strings.emplace_back(10).set_field(0, 10, code);
    double sum = 0;
    for (const double each : evaluate(*boom.problem(), strings, std::span(boom.record()).first(10), 400))
        sum += each;
    return sum;
}

Comparison compare_evaluations(const ReplayContext& context, Fingerprint& fingerprint) {
    Comparison table{.name = "an evaluation of the error, equations 3.5 to 3.8", .judged = true};
    const auto boom = context.examples / "occam/genetic/boom.occ";
    for (const auto& [column, cycles] : memories) {
        context.progress(fmt::format("boom, {}", column));
        const PrintedRun run = run_occam(boom, {.model = transputer::Model::t800}, cycles, context);
        fingerprint.mix(run.fingerprint);
        for (const char* way : ways_to_evaluate)
            table.add(compared_cell(way, column, "us", 72, run.number_behind(std::string(way) + ":"), 1));
        const bool equal = run.number_behind("fitness of all strings") == fitness_in_cpp();
        table.add(judged_by(Judge::own, judged_cell("fitness of the C++ library", column, "", 1, equal, 0, 0)));
    }
    table.notes = "72 us: 86.4 ms (Table E.1) / (120 strings x 10 samples). Columns: cycles of an access to external "
                  "memory.\nfitness of the C++ library: 1 if the program's fitness, with the orifices known, equals "
                  "the library's to the last bit\n";
    return table;
}

struct TimeOfTable {
    const char* row;
    std::array<double, 4> known;
};
constexpr std::array times_of_table{
    TimeOfTable{"T_exe", {97.0, 54.0, 39.7, 32.8}},   TimeOfTable{"T_sr", {86.4, 43.3, 29.5, 22.5}},
    TimeOfTable{"P_time2", {86.4, 43.3, 29.0, 21.8}}, TimeOfTable{"C_time2", {0.0, 0.6, 1.28, 1.89}},
    TimeOfTable{"S_time2", {10.5, 10.5, 10.5, 10.5}},
};

/// Runs a netlist of the thesis whose processes are in C++. The run has no slaves, because the strings are the same
/// with and without slaves.
RunReport run_in_cpp(const char* netlist, const ReplayContext& context) {
    return run_to_the_end(context.examples / "thesis" / netlist, {{"slaves", "0"}}, context);
}

/// Returns the hash of all strings that a process in C++ has bred, written as the programs in occam write a hash.
std::string hash_in_cpp(const RunReport& report, const char* process) {
    std::string hash = report.measured_text(process, "populations");
    std::ranges::transform(hash, hash.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return fmt::format("populations #{}#{}", hash.substr(0, 8), hash.substr(8));
}

/// Returns a cell with 1 if the program in occam has bred the same strings as the process in C++, otherwise with 0.
Cell cell_of_generations(const char* row, const std::string& column, const PrintedRun& run, const std::string& hash) {
    return judged_by(Judge::own, judged_cell(row, column, "", 1, run.text.find(hash) != run.text.npos, 0, 0));
}

/// A master and its slaves (a cluster) whose programs are in occam. With the usual generator of random numbers, the
/// cluster breeds the same strings as ga.master. The congruential generator needs less time.
struct SearchOfCluster {
    const char* name;
    const char* numbers; ///< name of the generator of random numbers
    const char* population;
    const char* generator;
    bool has_strings_of_cpp;
};
constexpr std::array searches_of_clusters{
    SearchOfCluster{"Table E.1, 120 individuals, with the random numbers of ga.master", "numbers of ga.master", "120",
                    "0", true},
    SearchOfCluster{"Table E.1, 120 individuals, with congruential random numbers", "congruential", "120", "1", false},
    SearchOfCluster{"Table E.1, 30 individuals, with congruential random numbers", "congruential", "30", "1", false},
};

PrintedRun run_cluster(const SearchOfCluster& search, std::size_t slaves, const ReplayContext& context) {
    return run_printing(context.examples / "occam/genetic/cluster.cfs",
                        {{"slaves", fmt::format("{}", slaves)},
                         {"population", search.population},
                         {"generator", search.generator},
                         {"seed", fmt::format("{}", context.seed)}},
                        context);
}

/// Compares the cluster's times with the times in the thesis.
Comparison compare_cluster(const SearchOfCluster& search, const ReplayContext& context, Fingerprint& fingerprint) {
    Comparison table{.name = search.name, .judged = search.has_strings_of_cpp};
    const RunReport in_cpp = run_in_cpp("table-e1/cluster.cfs", context);
    for (std::size_t slaves = 0; slaves < times_of_table.front().known.size(); ++slaves) {
        const std::string column = counted(slaves, "slave");
        context.progress(fmt::format("{}, {}", table.name, column));
        const PrintedRun run = run_cluster(search, slaves, context);
        fingerprint.mix(run.fingerprint);
        for (const TimeOfTable& time : times_of_table)
            table.add(compared_cell(time.row, column, "ms", time.known[slaves], run.number_behind(time.row), 2));
        if (search.has_strings_of_cpp)
            table.add(cell_of_generations("generations of ga.master", column, run, hash_in_cpp(in_cpp, "master")));
    }
    return table;
}

Comparison compare_islands(const ReplayContext& context, Fingerprint& fingerprint) {
    Comparison table{.name = "four islands in a ring", .against = "C++", .judged = true};
    const RunReport in_cpp = run_in_cpp("figure-e2/figure-e2.cfs", context);
    for (const auto& [row, netlist] : {std::pair{"without slaves (algorithm B)", "islands.cfs"},
                                       std::pair{"with three slaves each (A + B)", "figure-e2.cfs"}}) {
        context.progress(fmt::format("{}, {}", table.name, row));
        const PrintedRun run = run_printing(context.examples / "occam/genetic" / netlist,
                                            {{"seed", fmt::format("{}", context.seed)}}, context);
        fingerprint.mix(run.fingerprint);
        for (const char* island : {"master[0]", "master[1]", "master[2]", "master[3]"})
            table.add(cell_of_generations(row, island, run, hash_in_cpp(in_cpp, island)));
    }
    table.notes = "1: the hashes of all strings of 80 generations are equal\n";
    return table;
}

/// Compares the speedup of the machine of Figure E.2 over a single transputer with the speedup in the thesis.
Comparison compare_speedup(const ReplayContext& context) {
    Comparison table{.name = "speedup of sixteen transputers (A + B)"};
    for (const SearchOfCluster& search : {searches_of_clusters[0], searches_of_clusters[1]}) {
        const PrintedRun machine =
            run_printing(context.examples / "occam/genetic/figure-e2.cfs",
                         {{"generator", search.generator}, {"seed", fmt::format("{}", context.seed)}}, context);
        const double speedup = run_cluster(search, 0, context).number_behind("T_exe") / machine.number_behind("T_exe");
        table.add(compared_cell("speedup", search.numbers, "", 12, speedup, 2));
    }
    return table;
}

Replay replay_occam(const ReplayContext& context) {
    Fingerprint fingerprint;
    Replay replay{.comparisons = {compare_with_inmos(context, fingerprint), compare_evaluations(context, fingerprint)}};
    for (const SearchOfCluster& search : searches_of_clusters)
        replay.comparisons.push_back(compare_cluster(search, context, fingerprint));
    replay.comparisons.push_back(compare_islands(context, fingerprint));
    replay.comparisons.push_back(compare_speedup(context));
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace

extern const Experiment occam_experiment{
    .name = "occam",
    .about = "programs in occam, compared with INMOS's compiler and with the times of the thesis's programs",
    .chapter = "E",
    .number = 5,
    .run = replay_occam,
};

} // namespace placedpar
