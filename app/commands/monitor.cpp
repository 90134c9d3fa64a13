#include "app/command.hpp"
#include "app/identify/on_machine.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/standard_error.hpp"
#include "explore/process_search.hpp"
#include "gaprocs/fitness.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "identification/on_line/link_estimate.hpp"
#include "identification/transient_search.hpp"
#include "monitor/service/service.hpp"
#include "text/number.hpp"
#include "text/output_file.hpp"
#include "web/listener.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace placedpar::monitor {

using namespace identification;

namespace {

/// The range of an option's value, both ends included. Each range contains all practical values, and excludes overflows
/// and endless waits.
struct Bounds {
    double least, greatest;
};

constexpr Bounds timeouts{0.01, 86400};

/// Declares an option that accepts only a number within bounds. CLI11, the library that parses options, would accept
/// nan, read -1 as the greatest number, and read 010 as eight.
template <typename Number>
void add_number(Options& command, const std::string& group, const char* name, Number& value, const char* type,
                Bounds bounds, const char* about) {
    constexpr bool whole = std::is_integral_v<Number>;
    auto refuse = [bounds](const std::string& text) {
        std::optional<double> number = parse_number<double>(text);
        bool good = number && *number >= bounds.least && *number <= bounds.greatest;
        if (whole)
            good = good && text.find_first_not_of("0123456789") == text.npos && (text[0] != '0' || text == "0");
        return good ? std::string()
                    : fmt::format("\"{}\" is not a {} from {} to {}", text, whole ? "whole number" : "number",
                                  bounds.least, bounds.greatest);
    };
    command.add(name, value, fmt::format("{}, {} to {}", about, bounds.least, bounds.greatest))
        .type(type)
        .check(refuse)
        .show_default()
        .group(group);
}

void add_limits(Options& command, ServiceLimits& limits) {
    auto add = [&](const char* name, auto& value, const char* type, Bounds bounds, const char* about) {
        add_number(command, "Limits", name, value, type, bounds, about);
    };
    add("--max-clients", limits.clients, "N", {1, 65536}, "number of simultaneous connections");
    add("--max-machines", limits.machines, "N", {1, 1e6}, "number of machines known at the same time");
    add("--max-clients-per-peer", limits.clients_per_peer, "N", {1, 65536},
        "number of simultaneous connections from one address");
    add("--max-machines-per-peer", limits.machines_per_peer, "N", {1, 1e6},
        "number of machines that one address may be the first to announce");
    add("--max-takeovers", limits.takeovers_per_peer, "N", {1, 1e6},
        "number of times in a minute that one address may take over the control of a machine");
    add("--known-after", limits.known_s, "S", {0, 1e9},
        "a machine is known once it has sent samples over this time, and at least 1000 samples");
    add("--newcomer-timeout", limits.newcomer_s, "S", timeouts,
        "time without samples and connections after which a machine that is not yet known is forgotten");
    add("--history", limits.history, "N", {1, 1e6},
        "number of estimates, and of alarms, that the state file keeps for each machine");
    add("--max-line", limits.line_bytes, "BYTES", {100, 1 << 24}, "longest message");
    add("--max-queue", limits.queue_bytes, "BYTES", {1 << 14, 1 << 30},
        "largest number of bytes that wait to be sent to one client");
    add("--hello-timeout", limits.hello_s, "S", timeouts, "longest time between the connection and the client's hello");
    add("--line-timeout", limits.line_s, "S", timeouts, "longest time from the first byte of a line to the last");
    add("--idle-timeout", limits.idle_s, "S", timeouts, "longest time in which a client sends no line");
    add("--stall-timeout", limits.stall_s, "S", timeouts, "longest time in which a client reads nothing");
    add("--closing-timeout", limits.closing_s, "S", timeouts, "time that a client has to read the last message");
}

void add_diagnosis(Options& command, DiagnosisSettings& diagnosis) {
    auto add = [&](const char* name, auto& value, const char* type, Bounds bounds, const char* about) {
        add_number(command, "Diagnosis", name, value, type, bounds, about);
    };
    WindowSettings& window = diagnosis.search.window;
    add("--population", diagnosis.search.population, "N", {3, 10000}, "number of individuals in each population");
    add("--bits", diagnosis.bits, "N", {4, 16}, "number of bits that code one compliance");
    add("--window", window.length, "N", {1, exact_fitness_terms}, "number of samples in the search's window");
    add("--trials", window.trials, "N", {1, 1000}, "number of generations for each sample");
    add("--gate", diagnosis.gate.slope_psi_per_s, "PSI/S", {0, 1e6},
        "an estimate is frozen while the rms slope of the pressure is less than this");
    add("--inconsistent-over", diagnosis.inconsistent_over, "FRACTION", {0.01, 100},
        "estimates of a link are flagged if its compliances, found together with different other links, differ by "
        "more than this fraction");
    add("--stale-after", diagnosis.stale_after_s, "S", {0.01, 1e9},
        "estimates that are older than this are not used in cross-checks");
}

struct MonitorOptions {
    ServiceSettings settings;
    std::uint16_t port = 0, http = 0;
    std::string netlist;
    std::vector<std::string> set;
    ReadOptionsTyped read;
};

void add_options(Options& command, MonitorOptions& options) {
    ServiceSettings& settings = options.settings;
    auto add = [&](const char* name, auto& value, const char* type, Bounds bounds, const char* about) {
        add_number(command, "Options", name, value, type, bounds, about);
    };
    command.add("--address", settings.address, "address to listen on").show_default();
    add("--port", options.port, "N", {0, 65535}, "port to listen on; 0: any free port, which is printed");
    add("--http", options.http, "N", {0, 65535},
        "port for HTTP: a page for browsers, /metrics and /healthz; default: no "
        "HTTP");
    add_file(command, "--unix", settings.unix_path,
             "listens on this socket file; listens on a port only if --port is given, "
             "too",
             "PATH");
    add_file(command, "--token-file", settings.token_file, "file with the token that clients must send");
    command.add("--host-name", settings.host_names,
                "host name that browsers use for this server, such as a proxy's; may be repeated");
    add_file(command, "--state", settings.state, "SQLite file that keeps the state of all machines across restarts");
    add_seed(command, settings.seed);
    Option netlist = add_file(command, "--on", options.netlist,
                              "also identifies each movement by the processes of this netlist, as identify --way "
                              "thesis --on does, and says when the simulated machine would have answered",
                              "NETLIST");
    command.add_list("--set", options.set, "NAME=VALUE", "sets a val, an attribute or a parameter of the netlist")
        .needs(netlist);
    for (Option option : add_read_options(command, options.read))
        option.needs(netlist);
    add_limits(command, settings.limits);
    add_diagnosis(command, settings.diagnosis);
}

/// Returns the search for compliances by simulated transputers, as `identify --way thesis --on` makes it. First tries
/// the search on an artificial record, and throws UserError if the netlist cannot search.
auto search_on(const NetlistAsked& netlist, const ServiceSettings& settings) {
    IdentificationWay way = thesis_way();
    way.search.population = settings.diagnosis.search.population;
    way.search.window = settings.diagnosis.search.window;
    way.bits = settings.diagnosis.bits;
    auto search = [netlist, way, seed = settings.seed](ComplianceSearch prepared, double period_s) {
        std::string warnings;
        auto processes =
            search_by_processes(netlist, prepared, way, [&](const std::string& text) { warnings += text; });
        AnswerInTime found = answer_in_time(processes, prepared, period_s, seed);
        found.warnings = std::move(warnings);
        return found;
    };
    const hydraulics::FlowConstants flow = flow_constants(hydraulics::Parameters::excavator());
    ComplianceSearch made_up{CircuitProblem(hydraulics::boom_circuit(), flow, way.bits), flow, {}, {}};
    made_up.samples.resize(way.usable.count, {0, 0, {{}}});
    print_warnings(search(made_up, hydraulics::sampling_period_s).warnings);
    return [search, way](ComplianceSearch prepared, double period_s) {
        prepared.samples = usable_samples(prepared.samples, prepared.problem.circuit(), prepared.flow, way.usable);
        require_samples(prepared.samples, way);
        return search(std::move(prepared), period_s);
    };
}

void announce(const ServiceSettings& settings, const Service& service) {
    if (settings.port)
        print_out(fmt::format("placedpar monitor: listening on {} port {}\n", settings.address, service.port()));
    if (!settings.unix_path.empty())
        print_out(fmt::format("placedpar monitor: listening on {}\n", settings.unix_path));
    if (settings.http_port)
        print_out(fmt::format("placedpar monitor: page at http://{}:{}/\n", web::address_in_url(settings.address),
                              service.http_port()));
}

ExitCode serve(const ServiceSettings& settings) {
    std::signal(SIGXFSZ, SIG_IGN); // a write beyond the limit of a file's size then fails like a write to a full disk
    Log log(STDERR_FILENO);
    Service service(settings, log);
    service.heed_signals();
    announce(settings, service);
    service.run();
    log.say(settings.state.empty() ? "stopped" : fmt::format("stopped; the state was written to {}", settings.state));
    return ExitCode::success;
}

Action declare(Options& command, const std::string&) {
    auto options = std::make_shared<MonitorOptions>();
    add_options(command, *options);
    return [options, command] {
        ServiceSettings& settings = options->settings;
        settings.port = options->port;
        if (!settings.unix_path.empty() && !command.is_given("--port"))
            settings.port.reset();
        if (command.is_given("--http"))
            settings.http_port = options->http;
        if (!options->netlist.empty())
            settings.netlist = search_on({options->netlist, overrides_of(options->set),
                                          ParsedNetlist(options->netlist, read_options_of(options->read)), ""},
                                         settings);
        return serve(settings);
    };
}

} // namespace
} // namespace placedpar::monitor

namespace placedpar {

/// This command runs the service that diagnoses working excavators, until SIGINT or SIGTERM. It prints its addresses on
/// standard output, and messages for the operator on standard error.
extern const Command monitor_command{
    .name = "monitor",
    .about = "Serves the on-line diagnosis to control systems over TCP",
    .place = 100,
    .declare = monitor::declare,
};

} // namespace placedpar
