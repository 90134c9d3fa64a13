#include "app/command.hpp"
#include "app/options/booted_options.hpp"
#include "app/options/common_options.hpp"
#include "app/signals.hpp"
#include "iserver/board.hpp"
#include "iserver/terminal.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "netlist/kinds/booted_node.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

struct SendOptions {
    std::string file, to;
    BootedOptions booted;
};

double seconds(std::chrono::microseconds time) { return static_cast<double>(time.count()) * 1e-6; }

std::string print_end(const iserver::BoardRun& run) {
    switch (run.state) {
    case iserver::ServerState::running: return "was interrupted";
    case iserver::ServerState::waits_for_input: return "waits for input, and none will come";
    case iserver::ServerState::exited: break;
    }
    return run.exit == 0 ? "exited with success" : fmt::format("exited with status {}", run.exit);
}

/// Prints the times of the program on the board, measured by the clock of this computer.
std::string print_board_run(const SendOptions& options, std::size_t bytes, const iserver::BoardRun& run) {
    return fmt::format("{} on {}: the program {}\n"
                       "boot      {:10.6f} s   {} bytes, {:.0f} Kbyte/s\n"
                       "run       {:10.6f} s   {} requests\n",
                       options.file, options.to, print_end(run), seconds(run.boot_time), bytes,
                       static_cast<double>(bytes) / 1000 / std::max(seconds(run.boot_time), 1e-6),
                       seconds(run.run_time), run.requests);
}

ExitCode send(const SendOptions& options) {
    const std::vector<std::uint8_t> file = read_bootable(options.file);
    const HostServices host = services_of(options.booted);
    InterruptedBySignals interruption;
    std::signal(SIGPIPE, SIG_IGN); // a board that closes the connection is reported
    const auto interrupted = [&interruption] { return interruption.requested(); };
    const std::shared_ptr<iserver::Terminal> terminal = terminal_for(options.booted, interrupted)();
    iserver::Server server(server_options(host, options.file), *terminal);
    const iserver::OpenFile board = iserver::connect_board(options.to, interrupted);
    if (!board)
        return ExitCode::interrupted;
    const std::string_view program(reinterpret_cast<const char*>(file.data()), file.size());
    const iserver::BoardRun run = iserver::serve_board(program, board, options.to, server, interrupted);
    server.finish();
    print_out(print_board_run(options, file.size(), run));
    if (run.state == iserver::ServerState::running)
        return ExitCode::interrupted;
    return run.exit == 0 ? ExitCode::success : ExitCode::bad_input;
}

Action declare_send(Options& command, const std::string&) {
    auto options = std::make_shared<SendOptions>();
    command.add("FILE", options->file, "a bootable file").required().check(not_a_name);
    command.add("--to", options->to, "a character device, or tcp:HOST:PORT for a link adapter on a network")
        .type("BOARD")
        .required()
        .check(not_a_name);
    add_host(command, options->booted, "The program's host");
    return [options] { return send(*options); };
}

} // namespace

extern const Command send_command{
    .name = "send",
    .about = "Boots a real board with a file and serves its program",
    .place = 46,
    .declare = declare_send,
};

} // namespace placedpar
