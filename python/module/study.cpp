#include "python/module/interpreter.hpp"
#include "python/module/module.hpp"

#include "explore/explain/answers.hpp"
#include "explore/study/sweep.hpp"
#include "explore/workers.hpp"
#include "python/module/given.hpp"
#include "python/module/network.hpp"
#include "python/module/signals.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace placedpar::python {

namespace {

namespace py = pybind11;

/// The settings of a sweep: names, and the values of each.
using Axes = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Calls `progress` with the number of ended runs and the number of all runs, unless `progress` is None.
void tell(const py::object& progress, std::size_t ended, std::size_t all) {
    const py::gil_scoped_acquire locked;
    if (!progress.is_none())
        progress(ended, all);
}

StudyAxis axis_of(const std::string& name, const std::vector<std::string>& values) {
    StudyAxis axis{name, {}};
    for (const std::string& value : values)
        axis.parts.emplace_back(name, value);
    return axis;
}

Study study_of(const LoadedNetwork& network, const Axes& axes) {
    Study study;
    study.netlist = network.settings().file;
    study.read = network.settings().read;
    StudyProduct& product = study.products.emplace_back();
    Overrides fixed = network.settings().set;
    for (const auto& [name, values] : axes) {
        product.axes.push_back(axis_of(name, values));
        fixed.erase(name);
    }
    for (const auto& [name, value] : fixed)
        product.axes.push_back(axis_of(name, {value}));
    return study;
}

/// Makes the missing runs without Python's global lock, on `jobs` cores (0: all cores). `progress` is None, or a
/// function that receives the number of runs made so far and the number of runs that were missing.
void make_runs(const Study& study, StudyResults& results, std::size_t jobs, const py::object& progress) {
    InterruptedByKeyboard interruption;
    const py::gil_scoped_release unlocked;
    StudySweep sweep(study, results);
    sweep.try_measures(interruption);
    const std::uint64_t missing = sweep.missing().runs;
    const auto show = [&](std::uint64_t ended) { tell(progress, ended, missing); };
    sweep.run(std::min<std::uint64_t>(jobs > 0 ? jobs : count_cores(), std::max<std::uint64_t>(missing, 1)),
              interruption, show);
    if (!interruption.requested())
        show(missing);
}

py::dict row_of(const StudyRun& run, const StudyOutcome& outcome, const std::vector<StudyMeasure>& measures) {
    py::dict row;
    for (const auto& [name, value] : run.set)
        row[name.c_str()] = value;
    row["seed"] = run.seed;
    row["outcome"] = outcome.ended;
    for (const StudyMeasure& measure : measures) {
        const auto figure = outcome.has_figures() ? measure.of(outcome.figures) : std::nullopt;
        row[measure.text().c_str()] = figure ? py::cast(figure->value) : py::none();
    }
    return row;
}

py::list rows_of(const Study& study, StudyResults& results) {
    const std::vector<StudyMeasure> measures(study.measures.begin(), study.measures.end());
    const StudyRuns runs(study);
    py::list rows;
    for (std::uint64_t i = 0; i < runs.count(); ++i)
        if (const auto run = runs.at(i))
            if (const auto outcome = results.find(*run))
                rows.append(row_of(*run, *outcome, measures));
    return rows;
}

/// Makes the runs of the sweep, and returns a row for each run. `store` is a file in which the runs are stored; if it
/// is "", they are in memory only. REQUIRES: the network was read from a file, and has no process kinds in Python.
py::list sweep(const LoadedNetwork& network, const Axes& axes,
               const Given<std::vector<std::string>, "measure">& measures, std::uint64_t seed, std::uint64_t seeds,
               std::optional<std::int64_t> until_ps, const std::string& store, Given<std::size_t, "jobs"> jobs,
               const py::object& progress) {
    Study study = study_of(network, axes);
    study.first_seed = seed;
    study.seeds = seeds;
    study.until = limit_of_run(until_ps);
    study.measures = measures;
    for (const std::string& measure : study.measures)
        StudyMeasure{measure};
    require_possible(study.measures, study, readable_network(study));
    const StudySource source = source_of(study, network.network());
    const auto results =
        store.empty() ? std::make_unique<StudyResults>(source) : std::make_unique<StudyResults>(store, source);
    make_runs(study, *results, jobs, progress);
    heed_signals();
    return rows_of(study, *results);
}

/// Runs the network, measures the effect of changes, and returns the explanation as JSON and as text.
py::tuple explain(const LoadedNetwork& network, std::uint64_t seed, std::optional<std::int64_t> until_ps,
                  const py::object& progress) {
    if (network.has_own_kinds())
        throw UserError("explain tries changes on several threads, but the processes of this network are in "
                        "Python, which runs one at a time: compare the times of runs with changed settings, such as "
                        "net.changed({\"clock\": \"40M\"}).run(), or sweep(net, clock=[\"20M\", \"40M\"])");
    const Time until = limit_of_run(until_ps);
    CriticalPath path;
    FinishedRun run = network.run({seed, until, {}}, &path);
    Explanation explanation = explanation_of(std::move(run.report), path);
    {
        InterruptedByKeyboard interruption;
        const py::gil_scoped_release unlocked;
        add_answers(explanation, network.network(),
                    {network.parsed(), network.settings().set, seed, until,
                     [&progress](std::size_t ended, std::size_t all) { tell(progress, ended, all); }},
                    interruption);
    }
    heed_signals();
    return py::make_tuple(boost::json::serialize(explanation_json(explanation, network.network())),
                          print_explanation(explanation, network.network()));
}

} // namespace

void add_studies(py::module_& module) {
    module.def("explain", explain);
    module.def("sweep", sweep);
}

} // namespace placedpar::python
