// This program prints the report of a netlist's run as `placedpar run` does, and links only the rooms that a run needs.
// .ci/run compares what Clang's build of it prints with what GCC's build of placedpar prints: tests/fingerprints.py.

#include "explore/load.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "report/run_report.hpp"
#include "report/search_log.hpp"
#include "text/user_error.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

using namespace placedpar;

namespace {

constexpr const char* usage = "usage: netlist_reports run FILE [--seed N] [--set NAME=VALUE]...\n";
constexpr int success = 0, wrong_use = 1, deadlock = 2; // the exit codes of placedpar

struct Asked {
    std::string file;
    std::uint64_t seed = 1;
    Overrides set;
};

/// Throws UserError for anything but a file and options with their values.
Asked read_arguments(std::span<char*> arguments) {
    if (arguments.size() < 3 || arguments.size() % 2 == 0 || std::string(arguments[1]) != "run")
        throw UserError(usage);
    Asked asked{.file = arguments[2], .set = {}};
    for (std::size_t i = 3; i < arguments.size(); i += 2) {
        const std::string option = arguments[i], value = arguments[i + 1];
        if (option == "--seed")
            asked.seed = std::strtoull(value.c_str(), nullptr, 10);
        else if (option == "--set" && value.find('=') != std::string::npos)
            asked.set.emplace(value.substr(0, value.find('=')), value.substr(value.find('=') + 1));
        else
            throw UserError(usage);
    }
    return asked;
}

int print_run(const Asked& asked) {
    const ProblemRegistry problems = known_problems(asked.seed);
    const Network network = load_network(asked.file, asked.set, problems,
                                         [](const std::string& warning) { std::fputs(warning.c_str(), stderr); });
    GenerationLog log = log_of(network);
    const RunReport report = run_netlist(network, problems, {.seed = asked.seed, .observer = &log});
    std::fputs(print_report(report, network, log).c_str(), stdout);
    return report.result.ending == Ending::stuck ? deadlock : success;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return print_run(read_arguments(std::span(argv, static_cast<std::size_t>(argc))));
    } catch (const UserError& error) {
        std::fputs(error.what(), stderr);
        return wrong_use;
    }
}
