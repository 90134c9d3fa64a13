#include "app/options/netlist_options.hpp"

#include "app/options/common_options.hpp"
#include "explore/occam_program.hpp"
#include "explore/prediction/native_netlist.hpp"
#include "explore/problems.hpp"
#include "explore/workers.hpp"
#include "native/placement.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace placedpar {

Option add_set(Options& command, std::vector<std::string>& settings, const std::string& about) {
    return command.add_list("--set", settings, "NAME=VALUE", "NAME=VALUE: " + about);
}

namespace {

/// Splits `text` at its first `=`. If the text has no `=`, throws UserError, which states what the option takes.
std::pair<std::string, std::string> cut_at_equals(const std::string& option, const std::string& text,
                                                  const std::string& takes) {
    std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw UserError(fmt::format("{} {}: expected {}", option, text, takes));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

} // namespace

Overrides overrides_of(std::span<const std::string> settings, const std::string& option, const std::string& example) {
    Overrides overrides;
    for (const std::string& each : settings) {
        auto [name, value] = cut_at_equals(option, each, fmt::format("NAME=VALUE, such as {} {}", option, example));
        if (!overrides.emplace(name, value).second)
            throw UserError(fmt::format("{} {}: {} is set twice", option, each, name));
    }
    return overrides;
}

std::vector<Option> add_read_options(Options& command, ReadOptionsTyped& options) {
    return {command.add_list("-I", options.include, "FOLDER",
                             "folder to search for included files, besides the netlist's own; may be repeated"),
            command.add_list("--use", options.use, "PROGRAM=KIND",
                             "runs a process kind instead of a program that the netlist names, such as --use "
                             "sim.lku=ga.master"),
            command.add_list("--fault", options.fault, "FAULT",
                             "adds a fault, written as in a netlist, such as --fault 't[0].link[1] silent (from "
                             "= 20ms)'; may be repeated")};
}

ReadOptions read_options_of(const ReadOptionsTyped& typed) {
    ReadOptions options;
    options.make_netlist = netlist_maker({});
    options.faults = typed.fault;
    for (const std::string& folder : typed.include) {
        if (std::error_code error; !std::filesystem::is_directory(folder, error))
            throw UserError(fmt::format("-I {}: this folder does not exist", folder));
        options.include_folders.emplace_back(folder);
    }
    for (const std::string& each : typed.use) {
        auto [program, kind] = cut_at_equals("--use", each, "PROGRAM=KIND, such as --use sim.lku=ga.master");
        if (!options.programs.emplace(program, kind).second)
            throw UserError(fmt::format("--use {}: {} is given two kinds", each, program));
    }
    return options;
}

void add_netlist(Options& command, NetlistOptions& options) {
    command.add("FILE", options.file, "the netlist").required().check(not_a_name);
    add_set(command, options.set,
            "sets a val, an attribute or a parameter: slaves=3, linkspeed=10M, slave[2].elite=1; may be repeated");
    add_read_options(command, options.read);
}

void add_predict(Options& command, NetlistOptions& options) {
    const Option predict =
        add_file(command, "--predict", options.calibration,
                 "simulates a native run on the computer that FILE describes; placedpar calibrate writes such a file");
    add_number(command, "--ranks", options.ranks, 1, native::most_threads,
               "number of ranks of mpirun for which --predict simulates the run, instead of threads")
        .needs(predict);
}

namespace {

PredictedPlaces places_of(const NetlistOptions& options) {
    using enum PredictedPlaces::Kind;
    if (options.ranks > 0 && options.threads > 0)
        throw UserError("--ranks and --threads: a run is predicted either on ranks or on threads: give one of them");
    if (options.ranks > 0)
        return {ranks, options.ranks};
    return {threads, options.threads > 0 ? options.threads : count_cores()};
}

} // namespace

TypedNetlist parse_netlist(const NetlistOptions& options, const WarningSink& warn) {
    const ReadOptions read = read_options_of(options.read);
    TypedNetlist stated{ParsedNetlist(options.file, read), overrides_of(options.set)};
    if (options.calibration.empty())
        return stated;
    const ProblemRegistry problems = known_problems(0);
    const Network network = load_network(stated.parsed, stated.set, known_kinds(problems), warn);
    return {ParsedNetlist::of_text(native_netlist(network, places_of(options), options.calibration), options.file, {}),
            {}};
}

Network load_network(const NetlistOptions& options) {
    const TypedNetlist netlist = parse_netlist(options, options.warn);
    const ProblemRegistry problems = known_problems(0);
    return load_network(netlist.parsed, netlist.set, known_kinds(problems), options.warn);
}

} // namespace placedpar
