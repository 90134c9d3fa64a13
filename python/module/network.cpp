#include "python/module/network.hpp"
#include "python/module/interpreter.hpp"
#include "python/module/module.hpp"

#include "explore/occam_program.hpp"
#include "explore/problems.hpp"
#include "explore/study/measure.hpp"
#include "explore/time_text.hpp"
#include "iserver/terminal.hpp"
#include "netlist/print/print.hpp"
#include "observe/page/run_page.hpp"
#include "observe/trace/timeline.hpp"
#include "picture/svg.hpp"
#include "python/module/given.hpp"
#include "python/module/signals.hpp"
#include "report/run_report.hpp"
#include "report/search_log.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <pybind11/stl.h>

#include <optional>
#include <utility>

namespace placedpar::python {

namespace {

namespace py = pybind11;
using namespace pybind11::literals;

py::dict as_dict(const Diagnostic& diagnostic) {
    return py::dict("severity"_a = diagnostic.severity == Severity::error ? "error" : "warning",
                    "message"_a = diagnostic.message,
                    "file"_a = diagnostic.location.file ? diagnostic.location.file->path() : "",
                    "line"_a = diagnostic.location.line, "column"_a = diagnostic.location.column,
                    "hint"_a = diagnostic.hint, "text"_a = render(diagnostic));
}

/// Warns in Python. The warning shows the line of the user's program that read the attribute of a run, such as its
/// timeline.
void warn(const std::string& text) {
    py::module_::import("warnings").attr("warn")(text, error_named("NetlistWarning"), 3);
}

[[noreturn]] void refuse(const ReadResult& read) { raise("NetlistError", render(read), as_dicts(read.diagnostics)); }

ParsedNetlist parse(const LoadSettings& settings) {
    return settings.is_file ? ParsedNetlist(settings.file, settings.read)
                            : ParsedNetlist::of_text(settings.text, settings.file, settings.read);
}

std::vector<ProcessKind> kinds_of(const py::list& classes) {
    std::vector<ProcessKind> kinds;
    for (const py::handle each : classes)
        kinds.push_back(kind_of(each));
    return kinds;
}

/// Returns a verb for each activity.
std::string verb_of(Activity activity) {
    switch (activity) {
    case Activity::executing: return "executes";
    case Activity::carrying: return "carries";
    case Activity::computing: return "computes";
    case Activity::moving: return "moves words";
    case Activity::arbitrating: return "waits for the bus";
    default: return name_of(activity);
    }
}

/// Collects the slices of a timeline (activities with begin and end) for Python.
class SliceRows final : public TraceWriter {
public:
    explicit SliceRows(const Tracks& tracks) : tracks_(tracks) {}
    void write(const Slice& slice) override { slices_.push_back(slice); }
    void write(const MessageArrow&) override {}
    void finish(Time, Time, const std::string&) override {}

    /// Returns a tuple of lists: track, activity, begin and end in seconds, subject, bytes, partner.
    py::tuple columns() const {
        py::list track, activity, begin, end, subject, bytes, partner;
        for (const Slice& slice : slices_) {
            track.append(tracks_.all()[slice.track].name);
            activity.append(verb_of(slice.activity));
            begin.append(in_milliseconds(slice.begin) / 1e3);
            end.append(in_milliseconds(slice.end) / 1e3);
            subject.append(slice.subject);
            bytes.append(slice.bytes);
            partner.append(slice.awaited.size() == 1 ? slice.awaited.front().partner : "");
        }
        return py::make_tuple(track, activity, begin, end, subject, bytes, partner);
    }

private:
    const Tracks& tracks_;
    std::vector<Slice> slices_;
};

/// Returns the named measures of a run. A measure that this run does not have, or that is not a number, is
/// None. Throws UserError if runs of this
/// network cannot have the measure.
py::list figures_in(const LoadedNetwork& network, const FinishedRun& run, const std::vector<std::string>& measures) {
    const StudyFigures figures = figures_of(run.report, network.network());
    py::list found;
    for (const std::string& text : measures) {
        const StudyMeasure measure(text);
        const auto figure = measure.of(figures);
        if (!measure.is_in(figures) && run.report.outcome() == RunOutcome::completed)
            throw UserError(there_is_no_measure(measure, figures));
        found.append(figure ? py::cast(figure->value) : py::none());
    }
    return found;
}

/// Repeats the run and records it. Throws UserError if the repeated run differs from the first.
FinishedRun repeated(const LoadedNetwork& network, const FinishedRun& run, TraceSink& sink) {
    FinishedRun again = network.run(run.options, &sink);
    if (again.report.result.fingerprint != run.report.result.fingerprint)
        throw UserError(
            "the run cannot be recorded, because it differs each time it is repeated: a process in Python may use "
            "only its messages, its parameters and its random streams");
    return again;
}

py::tuple timeline_of(const LoadedNetwork& network, const FinishedRun& run) {
    Tracks tracks(network.network());
    SliceRows rows(tracks);
    Timeline timeline(tracks, {}, rows);
    const FinishedRun again = repeated(network, run, timeline);
    timeline.finish(again.report.result, name_of(again.report.outcome()));
    if (const auto full = timeline.full_at())
        warn("the timeline is full and ends at " + to_string(*full) + ", after " +
             std::to_string(TraceWindow{}.most_entries) + " entries: run(until=...) makes a shorter timeline");
    return rows.columns();
}

std::string page_of(const LoadedNetwork& network, const FinishedRun& run) {
    RunPage page(network.network(), {});
    const FinishedRun again = repeated(network, run, page.sink());
    return page.html({network.network(), again.report, again.manifest, again.log});
}

std::string json_of(const LoadedNetwork& network, const FinishedRun& run) {
    return boost::json::serialize(report_json(run.report, network.network(), run.manifest, run.log));
}

/// Logs the generations of a run, and stores the virtual time of the newest generation for other threads.
class ClockedLog final : public GenerationLog {
public:
    ClockedLog(const Network& network, RunClock* clock) : GenerationLog(log_of(network)), clock_(clock) {}
    using GenerationLog::observe;
    void observe(const ObservedGeneration& event) override {
        GenerationLog::observe(event);
        if (clock_ && event.time)
            clock_->picoseconds = event.time->count();
    }

private:
    RunClock* clock_; ///< null if no thread reads the time
};

/// Puts the lines of Python at which processes wait into the report. They replace lines in the C++ source of this
/// module, which do not help the user.
void set_places(RunReport& report, const std::map<std::string, std::string>& places) {
    if (report.result.deadlock)
        for (StuckProcess& process : report.result.deadlock->processes)
            if (const auto found = places.find(process.path); found != places.end())
                process.where = found->second;
}

/// Returns a line for each program that ended with an error, and for each of its processes that an error stopped.
std::string failures_of(const std::vector<ProgramUse>& programs) {
    std::string text;
    for (const ProgramUse& program : programs) {
        if (program.failed)
            text += program.name + " " + program.state + "\n";
        for (const ProgramUse::Stop& stop : program.stops)
            text += stop.process + " stopped at " + stop.place + ": " + stop.error + "\n";
    }
    return text;
}

void add_runs(py::module_& module) {
    py::class_<RunClock, std::shared_ptr<RunClock>>(module, "Clock")
        .def(py::init<>())
        .def_property_readonly("picoseconds", [](const RunClock& clock) { return clock.picoseconds.load(); });
    py::class_<FinishedRun>(module, "Run")
        .def_property_readonly("fingerprint", [](const FinishedRun& run) { return run.report.result.fingerprint; })
        .def_property_readonly("outcome",
                               [](const FinishedRun& run) { return std::string(name_of(run.report.outcome())); })
        .def_property_readonly("time_ps", [](const FinishedRun& run) { return run.report.result.time.count(); })
        .def_property_readonly("events", [](const FinishedRun& run) { return run.report.result.events; })
        .def("log_csv",
             [](const FinishedRun& run) {
                 return log_csv(std::vector<SeededLog>{{run.options.seed, run.log}});
             })
        .def_property_readonly("output", [](const FinishedRun& run) { return run.output; })
        .def("failure_text", [](const FinishedRun& run) { return failures_of(run.report.programs); })
        .def("deadlock_text", [](const FinishedRun& run) {
            return run.report.result.deadlock ? run.report.result.deadlock->text() : "";
        });
}

} // namespace

py::list as_dicts(const std::vector<Diagnostic>& diagnostics) {
    py::list all;
    for (const Diagnostic& each : diagnostics)
        all.append(as_dict(each));
    return all;
}

void raise(const char* error_class, const std::string& text, const py::list& diagnostics) {
    const py::object error = error_named(error_class)(text, diagnostics);
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
    throw py::error_already_set();
}

LoadedNetwork::LoadedNetwork(const LoadSettings& settings)
    : settings_(settings), parsed_(parse(settings_)), kinds_(kinds_of(settings_.kinds)) {
    const ProblemRegistry problems = known_problems(0);
    ReadResult read = parsed_.read(kinds(problems), settings_.set);
    if (!read.network)
        refuse(read);
    warnings_ = read.diagnostics;
    if (read.network->processes.empty() && read.network->nodes.empty())
        throw UserError(settings_.file + ": the netlist is empty: it declares no processors and no processes");
    network_ = std::move(*read.network);
}

Catalogue LoadedNetwork::kinds(const ProblemRegistry& problems, SearchObserver* observer) const {
    Catalogue catalogue = known_kinds(problems, observer);
    for (const ProcessKind& kind : kinds_) {
        if (catalogue.find(kind.name))
            throw UserError("there is a process kind \"" + kind.name + "\" already: give the class another `kind`");
        catalogue.add(kind);
    }
    return catalogue;
}

FinishedRun LoadedNetwork::run(const RunOptions& options, TraceSink* trace) const {
    ClockedLog log(network_, options.clock.get());
    const std::string command =
        "placedpar.load(\"" + settings_.file + "\").run(seed=" + std::to_string(options.seed) + ")";
    RunSettings settings{
        .seed = options.seed, .until = options.until, .shuffle = options.shuffle, .trace = trace, .observer = &log};
    std::string output;
    Network network = network_;
    network.host.terminal = [&] {
        return std::make_shared<iserver::ScriptedTerminal>(options.keys,
                                                           [&](std::string_view text) { output += text; });
    };
    RunReport report = run_unlocked(network, settings, options);
    heed_signals();
    if (report.result.ending == Ending::interrupted) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
        throw py::error_already_set();
    }
    Manifest manifest{command, options.seed, settings_.set, settings_.read, options.until, options.shuffle};
    return {std::move(report), std::move(log), std::move(manifest), options, std::move(output)};
}

RunReport LoadedNetwork::run_unlocked(const Network& network, const RunSettings& settings,
                                      const RunOptions& options) const {
    Interpreter interpreter;
    interpreter.clock = options.clock.get();
    InterruptedByKeyboard interruption;
    RunSettings interruptible = settings;
    interruptible.interruption = &interruption;
    try {
        const py::gil_scoped_release unlocked;
        const ProblemRegistry problems = known_problems(options.seed);
        RunReport report = run_netlist(network, kinds(problems, settings.observer), interruptible);
        set_places(report, interpreter.places);
        return report;
    } catch (const std::exception& error) {
        if (interpreter.failure().get())
            rethrow(interpreter.failure(), "ProcessError", error.what());
        throw;
    }
}

void add_networks(py::module_& module) {
    add_runs(module);
    py::class_<LoadedNetwork, std::shared_ptr<LoadedNetwork>>(module, "Network")
        .def(py::init([](std::string file, std::string text, bool is_file, Given<Overrides, "settings"> set,
                         std::vector<std::string> include, Given<std::vector<std::string>, "faults"> faults,
                         Given<ProgramKinds, "use"> use, py::list kinds) {
            ReadOptions read;
            read.include_folders.assign(include.begin(), include.end());
            read.faults = faults;
            read.programs = use;
            read.make_netlist = netlist_maker({});
            return std::make_shared<LoadedNetwork>(
                LoadSettings{std::move(file), std::move(text), is_file, set, std::move(read), std::move(kinds)});
        }))
        .def("run",
             [](const LoadedNetwork& network, std::uint64_t seed, std::optional<std::int64_t> until_ps,
                std::optional<std::uint64_t> shuffle, std::shared_ptr<RunClock> clock,
                Given<std::string, "keys"> keys) {
                 return network.run({seed, limit_of_run(until_ps), shuffle, std::move(clock), keys});
             })
        .def("report_json", json_of)
        .def("report_text", [](const LoadedNetwork& network,
                               const FinishedRun& run) { return print_report(run.report, network.network(), run.log); })
        .def("timeline", timeline_of)
        .def("page", page_of)
        .def("svg", [](const LoadedNetwork& network) { return print_svg(network.network()); })
        .def("software_svg", [](const LoadedNetwork& network) { return print_software_svg(network.network()); })
        .def("cfs",
             [](const LoadedNetwork& network) {
                 require_netlist(network.settings().file);
                 return print_cfs(network.network());
             })
        .def_property_readonly("warnings", [](const LoadedNetwork& network) { return as_dicts(network.warnings()); })
        .def("figures", figures_in)
        .def_property_readonly("path", [](const LoadedNetwork& network) { return network.network().source_path; })
        .def_property_readonly("counts", [](const LoadedNetwork& network) {
            const Network& its = network.network();
            return py::make_tuple(its.nodes.size(), its.processes.size(), its.channels.size());
        });
    module.def("parse_time", [](const std::string& text) { return parse_time(text).count(); });
}

} // namespace placedpar::python
