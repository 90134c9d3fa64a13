#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/many_runs.hpp"
#include "app/options/netlist_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/load.hpp"
#include "explore/optimise/optimise_report.hpp"
#include "explore/problems.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "explore/study/sweep.hpp"
#include "explore/workers.hpp"
#include "picture/gnuplot.hpp"
#include "ranks/ranks.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

struct OptimiseOptions {
    std::string study;
    std::optional<std::uint64_t> seed, population, generations;
    std::optional<Time> until;
    bool random = false, exhaustive = false;
    std::string results; ///< "": the file is named after the study
    std::string csv, svg;
    std::vector<std::string> price;
    std::size_t jobs = 0;
    bool yes = false, any_version = false;

    std::array<std::filesystem::path, 2> outputs() const { return {csv, svg}; }
    std::filesystem::path kept() const {
        return results.empty() ? std::filesystem::path(study).stem().string() + ".sqlite" : results;
    }
};

double price_in(const std::string& part, const std::string& text) {
    const auto price = parse_number<double>(text);
    if (!price || !(*price >= 0 && *price <= 1e12))
        throw UserError(fmt::format("--price {}={}: expected a number from 0 to 1e12", part, text));
    return *price;
}

Study searched_study(const OptimiseOptions& options) {
    if (!lower_case(options.study).ends_with(".toml"))
        throw UserError(fmt::format("{}: expected a study (.toml) with a table [search]", options.study));
    Study study = read_study(options.study);
    if (!study.search)
        throw UserError(fmt::format("{}: the study has no table [search]; add one that names the measure to "
                                    "minimise: minimise = \"time\"",
                                    options.study));
    study.search->seed = options.seed.value_or(study.search->seed);
    study.search->population = options.population.value_or(study.search->population);
    study.search->generations = options.generations.value_or(study.search->generations);
    study.until = options.until.value_or(study.until);
    for (const auto& [part, price] : overrides_of(options.price, "--price", "T800=300"))
        study.prices[part] = price_in(part, price);
    return study;
}

void require_optimise_outputs(const OptimiseOptions& options) {
    require_apart(options.outputs(), options.study);
    require_apart(options.outputs(), options.kept());
    for (const auto& path : options.outputs())
        if (!path.empty())
            require_writable(path);
    if (!options.svg.empty())
        require_gnuplot();
}

Network network_with(const Study& study, const Overrides& settings) {
    return load_network(
        study.netlist, settings, known_problems(0), [](const std::string&) {}, study.read);
}

/// Returns the network of the unchanged netlist. If this network is not valid, returns the network of one of the
/// machines among which the study searches.
Network some_network(const Study& study, const MachineSpace& space) {
    try {
        return network_with(study, space.fixed());
    } catch (const UserError&) {
        return readable_network(study);
    }
}

/// Returns the files of the study. Throws UserError if no process or device reports a demanded measure, or if an output
/// file is a file of the netlist.
StudySource searchable_source(const OptimiseOptions& options, const Study& study, const MachineSpace& space) {
    Network network = some_network(study, space);
    require_possible(shown_measures(study), study, network);
    StudySource source = source_of(study, network);
    for (const auto& [path, text] : source.texts)
        require_apart(options.outputs(), path);
    return source;
}

std::string told(const CourseProgress& progress) {
    std::string out = fmt::format("{}: {}", progress.step, counted(progress.course.machines.size(), "machine"));
    if (progress.runs > 0)
        out += fmt::format(" and {}", counted(progress.runs, "run"));
    std::vector<std::size_t> front = progress.course.front();
    if (!front.empty())
        out += fmt::format(", best {:.6g}", progress.course.merits[front.front()].costs.front());
    return out;
}

/// The search in progress and everything that it needs.
struct Session {
    const OptimiseOptions& options;
    Study study = searched_study(options);
    MachineSpace space{study};
    StudySource source = searchable_source(options, study, space);
    StudyResults results{options.kept(), source, options.any_version};
    InterruptedBySignals interruption{};
    MachineTrials trials{study, space, results, options.jobs, interruption};
};

/// Returns the largest number of runs that the search can need, including runs that are already stored. If the number
/// exceeds 64 bits, returns the greatest integer.
std::uint64_t most_runs(const Session& session) {
    const StudySearch& wanted = *session.study.search;
    std::uint64_t bred = wanted.population - wanted.population / 2;
    std::uint64_t drawn = std::min(session.space.count(), wanted.population + bred * (wanted.generations - 1));
    std::uint64_t machines = session.options.random ? std::min(session.space.count(), 2 * drawn) : drawn;
    if (session.options.exhaustive)
        machines = session.space.count();
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    return machines > most / session.study.seeds ? most : session.study.seeds * machines;
}

std::optional<double> seconds_of(const Study& study, Session& session) {
    return StudySweep(study, session.results).seconds_a_run(session.interruption);
}

/// Returns how long this computer needs for a run of the unchanged netlist. If this netlist is not valid, returns the
/// time for the first machine. Returns nullopt after an interruption.
std::optional<double> seconds_of_a_run(Session& session) {
    std::optional<double> seconds = seconds_of(study_of(session.study, {session.space.fixed()}), session);
    std::optional<StudyOutcome> start = session.results.find({session.space.fixed(), session.study.first_seed});
    return start && start->refused.empty() ? seconds : seconds_of(session.study, session);
}

/// Returns whether to begin the search. Asks the user first if the search may need very many runs. Returns false if the
/// session was interrupted.
bool is_meant(Session& session) {
    std::uint64_t runs = most_runs(session);
    if (runs <= most_unasked || session.options.yes)
        return true;
    std::optional<double> seconds = seconds_of_a_run(session);
    return seconds && are_meant({runs, false, session.options.jobs, *seconds}, session.interruption);
}

/// Makes the genetic search, and the random and the exhaustive search if the options request them. Returns false if a
/// search was interrupted.
bool go_all_ways(Session& session, MachineSearch& search, Optimum& optimum) {
    auto add = [&](std::optional<SearchCourse> course) {
        if (course && optimum.courses.empty() && course->front().empty())
            throw UserError(print_why_none(*course));
        if (course)
            optimum.courses.push_back(std::move(*course));
        return course.has_value();
    };
    return add(search.genetic()) &&
           (!session.options.random || add(search.random(optimum.courses.front().machines.size()))) &&
           (!session.options.exhaustive || add(search.exhaustive()));
}

/// Makes all searches and returns their results. Returns nullopt if a search was interrupted, or if the user did not
/// confirm the number of runs.
std::optional<Optimum> search_for(Session& session) {
    Optimum optimum;
    optimum.measures = session.study.search->minimise;
    if (!is_meant(session))
        return std::nullopt;
    std::optional<Trial> start = session.trials.of(session.space.fixed());
    if (!start)
        return std::nullopt;
    optimum.start = *start;
    ProgressLine line;
    MachineSearch search(session.study, session.space, session.trials,
                         [&](const CourseProgress& progress) { line.show(told(progress)); });
    return go_all_ways(session, search, optimum) ? std::optional(std::move(optimum)) : std::nullopt;
}

/// Returns the critical path of a run with these settings. Returns nullopt if the run was interrupted, or if the path
/// is too long to be kept.
std::optional<std::vector<PathPart>> path_of(Session& session, const Overrides& settings) {
    CriticalPath path;
    RunReport report = run_netlist(network_with(session.study, settings), known_problems(session.study.first_seed),
                                   {.seed = session.study.first_seed,
                                    .until = session.study.until,
                                    .trace = &path,
                                    .interruption = &session.interruption});
    bool known = report.result.ending != Ending::interrupted && !path.too_long();
    return known ? std::optional(path.parts()) : std::nullopt;
}

/// Explains why the best machine and the unchanged netlist take different times. Returns "" if the unchanged netlist is
/// not valid or the search was interrupted.
std::string reason_of(Session& session, const Optimum& optimum, const Overrides& best) {
    if (!optimum.start.merit.feasible)
        return "";
    ProgressLine line;
    line.show("comparing critical paths: two runs");
    auto start = path_of(session, session.space.fixed()), end = path_of(session, best);
    if (start && end)
        return print_paths(*start, *end) + "\n";
    return session.interruption.requested() ? ""
                                            : "the critical paths are not compared, because the runs are too long\n\n";
}

/// Returns the settings of the best machine, whichever search found it.
Overrides best_settings(const Session& session, const SearchCourse& all) {
    return session.space.settings(all.machines[best_of(all).front()]);
}

void print_optimum(Session& session, const Optimum& optimum, const StudySummary& summary) {
    const Overrides best = best_settings(session, optimum.together());
    print_out(fmt::format("{} of {}; the best combinations:\n\n{}\n{}\n", counted(session.space.count(), "combination"),
                          counted(session.space.names().size(), "setting"), print_summary(summary),
                          print_comparison(optimum)));
    print_out(reason_of(session, optimum, best) + fmt::format("the best: {}\nresults: {}\n",
                                                              command_of(session.study, best),
                                                              session.results.path().string()));
}

/// Reports an interruption, if there was one. All runs made so far stay stored, so that the search can continue later.
ExitCode end_of(const Session& session) {
    if (!session.interruption.requested())
        return ExitCode::success;
    print_error(fmt::format("interrupted; {} keeps the finished runs: type the same command again to continue\n",
                            session.results.path().string()));
    return ExitCode::interrupted;
}

ExitCode optimise(const OptimiseOptions& typed) {
    if (left_to_rank_zero("optimise"))
        return ExitCode::success;
    OptimiseOptions options = typed;
    options.jobs = options.jobs == 0 ? count_cores() : options.jobs;
    require_optimise_outputs(options);
    Session session{options};
    session.results.set_measures(shown_measures(session.study));
    std::optional<Optimum> optimum = search_for(session);
    if (!optimum)
        return end_of(session);
    StudySummary summary = summary_of_best(session.results, session.study, session.space, optimum->together());
    for (std::size_t i = 0; i < optimum->measures.size(); ++i)
        optimum->measures[i] = measure_with_unit(summary, i);
    print_optimum(session, *optimum, summary);
    if (!options.csv.empty())
        write_whole(options.csv, summary_csv(summary));
    if (!options.svg.empty())
        write_whole(options.svg, draw_svg(optimum_plot(*optimum, session.study.netlist)));
    return end_of(session);
}

void add_search_size(Options& command, OptimiseOptions& options) {
    add_count(command, "--seed", options.seed, "seed of the search's random numbers; default: the study's seed");
    add_number(command, "--population", options.population, 4, StudySearch::most_population,
               "number of machines in a generation");
    add_number(command, "--generations", options.generations, 1, StudySearch::most_generations,
               "number of generations");
    command.add("--until", options.until, "stops each run at this simulated time");
    add_jobs(command, options.jobs, "number of parallel runs; default: number of cores");
}

Action declare_optimise(Options& command, const std::string&) {
    auto options = std::make_shared<OptimiseOptions>();
    command.add("STUDY", options->study, "a study (.toml) with a table [search]").required().check(not_a_named_file);
    add_search_size(command, *options);
    command.add_list(
        "--price", options->price, "PART=PRICE",
        "price of one part of a type, such as T800, C004 or link, for the measure \"price\"; may be repeated");
    command.add_flag("--random", options->random,
                     "also tries the same number of machines drawn at random, for comparison");
    command.add_flag("--exhaustive", options->exhaustive, "also tries all machines, for comparison");
    add_file(command, "--results", options->results,
             "file of the results, which is read and extended; default: the study's name with .sqlite, in the current "
             "folder");
    add_file(command, "--csv", options->csv,
             "writes the best machines, or the Pareto front, as comma-separated values");
    add_file(command, "--svg", options->svg, "draws the course of the search, or the Pareto front");
    command.add_flag("--yes", options->yes, "starts any number of runs without asking");
    command.add_flag("--any-version", options->any_version,
                     "adds runs even if another version of PlacedPar made the results in the file");
    return [options] { return optimise(*options); };
}

} // namespace

extern const Command optimise_command{
    .name = "optimise",
    .about = "Finds a study's best machine with a genetic algorithm, and says why it is the best",
    .place = 24,
    .declare = declare_optimise,
};

} // namespace placedpar
