#pragma once

#include "explore/netlist_run.hpp"
#include "gaprocs/generation_log.hpp"
#include "netlist/read.hpp"
#include "python/module/interpreter.hpp"
#include "report/manifest.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::python {

/// The settings with which a network is loaded.
struct LoadSettings {
    std::string file; ///< path of the netlist; "netlist" if the netlist is a text
    std::string text; ///< the netlist itself, if it is not in a file
    bool is_file = true;
    Overrides set;
    ReadOptions read;
    pybind11::list kinds; ///< subclasses of placedpar.Process
};

/// The settings of a run.
struct RunOptions {
    std::uint64_t seed = 1;
    Time until = Time::max();
    std::optional<std::uint64_t> shuffle = {};
    std::shared_ptr<RunClock> clock = {}; ///< null if no thread reads the time during the run
    std::string keys = "";                ///< keys that are pressed for programs that a host computer boots and serves
};

/// Returns the simulated time at which a run ends. Without a value, the run has no limit.
inline Time limit_of_run(std::optional<std::int64_t> until_ps) { return until_ps ? Time{*until_ps} : Time::max(); }

/// A finished run of a network.
struct FinishedRun {
    RunReport report;
    GenerationLog log;
    Manifest manifest;
    RunOptions options;
    std::string output; ///< text that programs with a host wrote to the screen
};

/// A netlist, a configuration or a program in occam that has been read, with the process kinds that the user wrote in
/// Python.
class LoadedNetwork {
public:
    /// If the netlist has errors, throws the Python exception NetlistError with all diagnostics.
    explicit LoadedNetwork(const LoadSettings&);

    const Network& network() const { return network_; }
    const ParsedNetlist& parsed() const { return parsed_; }
    const LoadSettings& settings() const { return settings_; }
    /// Returns the warnings about the netlist.
    const std::vector<Diagnostic>& warnings() const { return warnings_; }
    bool has_own_kinds() const { return !kinds_.empty(); }
    Catalogue kinds(const ProblemRegistry&, SearchObserver* = nullptr) const;

    /// Runs the network without Python's global lock. Rethrows the first exception of a process in Python.
    FinishedRun run(const RunOptions&, TraceSink* = nullptr) const;

private:
    RunReport run_unlocked(const Network&, const RunSettings&, const RunOptions&) const;

    LoadSettings settings_;
    ParsedNetlist parsed_;
    std::vector<ProcessKind> kinds_;
    std::vector<Diagnostic> warnings_;
    Network network_;
};

/// Makes a process kind, which netlists can name, of a subclass of placedpar.Process. REQUIRES: the caller holds
/// Python's global lock. Throws UserError if the class does not describe a kind.
ProcessKind kind_of(pybind11::handle process_class);
/// Returns a dictionary for each error and warning. REQUIRES: the caller holds Python's global lock.
pybind11::list as_dicts(const std::vector<Diagnostic>&);
/// Raises an exception of the class `error_class` of placedpar.errors, with this text and these diagnostics. REQUIRES:
/// the caller holds Python's global lock.
[[noreturn]] void raise(const char* error_class, const std::string& text, const pybind11::list& diagnostics);

} // namespace placedpar::python
