#include "app/monitor/monitor_command.hpp"

#include "app/common_options.hpp"
#include "app/monitor/service.hpp"
#include "app/standard_output.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstddef>
#include <memory>
#include <string>

namespace placedpar::monitor {

namespace {

std::string at_least_one(const std::string& count) { return count == "0" ? "it is at least 1" : ""; }

/// An option in seconds: more than none, and such as a clock can count.
void add_seconds(CLI::App& command, const char* option, double& value, const char* about, const char* group) {
    static constexpr double longest_s = 1e9; // 30 years
    command.add_option(option, value, about)
        ->type_name("S")
        ->check([](const std::string& text) {
            double seconds = 0;
            bool good = CLI::detail::lexical_cast(text, seconds) && seconds > 0 && seconds <= longest_s;
            return good ? std::string()
                        : fmt::format("\"{}\" is no number of seconds above 0 and up to {}", text, longest_s);
        })
        ->capture_default_str()
        ->group(group);
}

void add_limits(CLI::App& command, ServiceLimits& limits) {
    constexpr const char* group = "Limits";
    auto count = [&](const char* option, std::size_t& value, const char* about, const char* unit) {
        add_count(command, option, value, about, unit)->check(at_least_one)->group(group);
    };
    auto seconds = [&](const char* option, double& value, const char* about) {
        add_seconds(command, option, value, about, group);
    };
    count("--max-clients", limits.clients, "connections at once", "N");
    count("--max-machines", limits.machines, "machines known at once", "N");
    count("--max-line", limits.line_bytes, "length of a message", "BYTES");
    count("--max-queue", limits.queue_bytes, "waiting to be sent to one client", "BYTES");
    seconds("--hello-timeout", limits.hello_s, "from the connection to the hello");
    seconds("--line-timeout", limits.line_s, "from the first byte of a line to the last");
    seconds("--idle-timeout", limits.idle_s, "without a line");
    seconds("--stall-timeout", limits.stall_s, "without the client reading");
    seconds("--closing-timeout", limits.closing_s, "for a client to read the last message");
}

void add_diagnosis(CLI::App& command, DiagnosisSettings& diagnosis) {
    constexpr const char* group = "Diagnosis";
    auto count = [&](const char* option, std::size_t& value, const char* about) {
        add_count(command, option, value, about)->group(group);
    };
    auto number = [&](const char* option, double& value, const char* about, const char* unit) {
        command.add_option(option, value, about)->type_name(unit)->capture_default_str()->group(group);
    };
    count("--population", diagnosis.search.population, "individuals of a population set");
    count("--bits", diagnosis.bits, "of one compliance");
    count("--window", diagnosis.search.window.length, "samples of the window");
    count("--trials", diagnosis.search.window.trials, "generations a sample");
    number("--gate", diagnosis.gate_psi_per_s, "rms slope of the pressure below which an estimate is frozen", "PSI/S");
    number("--doubled-at", diagnosis.doubled_at, "alarm at this many times the baseline", "RATIO");
    number("--inconsistent-over", diagnosis.inconsistent_over, "alarm at this spread between population sets",
           "FRACTION");
    number("--off-by", diagnosis.off_by, "a link further from its baseline is off", "FRACTION");
    count("--transients", diagnosis.transients, "settled transients before a link may be called off");
    number("--stale-after", diagnosis.stale_after_s, "older estimates take no part in cross-checks", "S");
}

void add_options(CLI::App& command, ServiceSettings& settings) {
    command.add_option("--address", settings.address, "where to listen")->capture_default_str();
    command.add_option("--port", settings.port, "0: any free one, which is printed")
        ->type_name("N")
        ->check(not_a_whole_number)
        ->capture_default_str();
    add_file(command, "--state", settings.state, "keeps what is known over a restart, with FILE.journal beside it");
    add_seed(command, settings.seed);
    add_seconds(command, "--sync", settings.sync_s, "from a sample to its being on the disk, if power fails",
                "Options");
    add_limits(command, settings.limits);
    add_diagnosis(command, settings.diagnosis);
}

ExitCode serve(const ServiceSettings& settings) {
    auto say = [](const std::string& sentence) { fmt::print(stderr, "placedpar monitor: {}\n", sentence); };
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is like a full disk, no reason to end
    Service service(settings, say);
    print_out(fmt::format("placedpar monitor: listening on {} port {}\n", settings.address, service.port()));
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
