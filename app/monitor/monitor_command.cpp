#include "app/monitor/monitor_command.hpp"

#include "app/monitor/service.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <string>

namespace placedpar::monitor {

namespace {

void add_limits(CLI::App& command, ServiceLimits& limits) {
    auto add = [&](const char* name, auto& value, const char* about, const char* unit) {
        command.add_option(name, value, about)
            ->type_name(unit)
            ->check(CLI::PositiveNumber)
            ->capture_default_str()
            ->group("Limits");
    };
    add("--max-clients", limits.clients, "connections at once", "N");
    add("--max-machines", limits.machines, "machines known at once", "N");
    add("--max-line", limits.line_bytes, "length of a message", "BYTES");
    add("--max-queue", limits.queue_bytes, "waiting to be sent to one client", "BYTES");
    add("--hello-timeout", limits.hello_s, "from the connection to the hello", "S");
    add("--line-timeout", limits.line_s, "from the first byte of a line to the last", "S");
    add("--idle-timeout", limits.idle_s, "without a line", "S");
    add("--stall-timeout", limits.stall_s, "without the client reading", "S");
    add("--closing-timeout", limits.closing_s, "for a client to read the last message", "S");
}

void add_diagnosis(CLI::App& command, DiagnosisSettings& diagnosis) {
    auto add = [&](const char* name, auto& value, const char* about, const char* unit) {
        command.add_option(name, value, about)->type_name(unit)->capture_default_str()->group("Diagnosis");
    };
    add("--population", diagnosis.search.population, "individuals of a population set", "N");
    add("--bits", diagnosis.bits, "of one compliance", "N");
    add("--window", diagnosis.search.window.length, "samples of the window", "N");
    add("--trials", diagnosis.search.window.trials, "generations a sample", "N");
    add("--gate", diagnosis.gate_psi_per_s, "rms slope of the pressure below which an estimate is frozen", "PSI/S");
    add("--doubled-at", diagnosis.doubled_at, "alarm at this many times the baseline", "RATIO");
    add("--inconsistent-over", diagnosis.inconsistent_over, "alarm at this spread between population sets", "FRACTION");
    add("--off-by", diagnosis.off_by, "a link further from its baseline is off", "FRACTION");
    add("--transients", diagnosis.transients, "settled transients before a link may be called off", "N");
    add("--stale-after", diagnosis.stale_after_s, "older estimates take no part in cross-checks", "S");
}

void add_options(CLI::App& command, ServiceSettings& settings) {
    command.add_option("--address", settings.address, "where to listen")->capture_default_str();
    command.add_option("--port", settings.port, "0: any free one, which is printed")
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--state", settings.state, "keeps what is known over a restart, with FILE.journal beside it")
        ->type_name("FILE");
    command.add_option("--seed", settings.seed, "of every random stream")->type_name("N")->capture_default_str();
    command.add_option("--sync", settings.sync_s, "from a sample to its being on the disk, if power fails")
        ->type_name("S")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    add_limits(command, settings.limits);
    add_diagnosis(command, settings.diagnosis);
}

ExitCode serve(const ServiceSettings& settings) {
    auto say = [](const std::string& sentence) { fmt::print(stderr, "placedpar monitor: {}\n", sentence); };
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is like a full disk, no reason to end
    Service service(settings, say);
    fmt::print("placedpar monitor: listening on {} port {}\n", settings.address, service.port());
    std::fflush(stdout);
    service.run(true);
    say(settings.state.empty() ? "stopped" : fmt::format("stopped; {} is written", settings.state));
    return ExitCode::success;
}

} // namespace

void declare(CLI::App& app, ChosenCommand& chosen) {
    auto* command = app.add_subcommand("monitor", "Serves the on-line diagnosis to control systems over TCP");
    auto settings = std::make_shared<ServiceSettings>();
    add_options(*command, *settings);
    command->callback([&chosen, settings] { chosen = [settings] { return serve(*settings); }; });
}

} // namespace placedpar::monitor
