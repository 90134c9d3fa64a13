#include "app/command.hpp"
#include "app/options/booted_options.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/signals.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "iserver/board.hpp"
#include "iserver/terminal.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "netlist/kinds/booted_node.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"
#include "text/paint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

struct SendOptions {
    std::string file, to;
    BootedOptions booted;
};

double in_seconds(std::chrono::duration<double> time) { return time.count(); }

std::string print_end(const iserver::BoardRun& run) {
    switch (run.state) {
    case iserver::ServerState::running: return "was interrupted";
    case iserver::ServerState::waits_for_input: return "waits for input, but the input has ended";
    case iserver::ServerState::exited: break;
    }
    return run.exit == 0 ? "exited with success" : fmt::format("exited with status {}", run.exit);
}

/// A host that repeats the replies of an earlier run on a board with real transputers. The simulation of the same
/// program then gets the same replies. If a request differs from the request on the board, the host does not reply.
class RepeatedHost {
public:
    explicit RepeatedHost(std::span<const iserver::Exchange> exchanges) : exchanges_(exchanges) {}

    iserver::Answer answer(iserver::ByteView request) {
        const bool same = next_ < exchanges_.size() && std::ranges::equal(request, exchanges_[next_].request);
        departed_ = !same;
        if (departed_)
            return {.reply = {}, .state = iserver::ServerState::waits_for_input};
        return exchanges_[next_++].answer;
    }
    /// Returns the number of requests that were equal on the board and in the simulation.
    std::size_t repeated() const { return next_; }
    bool departed() const { return departed_; }

private:
    std::span<const iserver::Exchange> exchanges_;
    std::size_t next_ = 0;
    bool departed_ = false;
};

/// The times of the program on a simulated transputer.
struct SimulatedTimes {
    double boot = 0, run = 0;   ///< seconds
    std::string departure = ""; ///< difference between the simulated run and the run on the board; "" if there is none
};

/// Simulates the program with the replies from the run on the board. Stops the simulated run if it takes much longer
/// than the run on the board. Returns nullopt if the program cannot be read again, or did not end on the board.
std::optional<SimulatedTimes> simulate(const SendOptions& options, const Options& typed, const iserver::BoardRun& board,
                                       Interruption& interruption) {
    if (!looks_bootable(options.file) || board.state == iserver::ServerState::running ||
        board.exchanges.size() < board.requests)
        return std::nullopt;
    NetlistOptions netlist;
    netlist.file = options.file;
    Network network = load_network(typed, netlist, options.booted);
    RepeatedHost host(board.exchanges);
    network.host.answers = [&host](iserver::ByteView request, std::chrono::microseconds) {
        return host.answer(request);
    };
    const Time until = 100 * Time{board.boot_time + board.run_time} + std::chrono::seconds(1);
    const RunReport report = run_netlist(network, known_problems(0), {.until = until, .interruption = &interruption});
    if (interruption.requested())
        return std::nullopt;
    const Time booted = report.programs.front().booted_at;
    SimulatedTimes times{.boot = in_seconds(booted), .run = in_seconds(report.result.time - booted)};
    if (host.departed())
        times.departure = fmt::format("request {} differs from the board's request", host.repeated() + 1);
    else if (host.repeated() < board.requests)
        times.departure =
            fmt::format("it ends after {}: {}", counted(host.repeated(), "request"), report.programs.front().state);
    return times;
}

/// Prints the time on the board, measured by the clock of this computer, and the simulated time.
std::string print_times(const std::string& what, std::chrono::microseconds measured, std::optional<double> simulated,
                        const std::string& more) {
    return fmt::format("{:<9}  {:10.6f} s  {:>12}   {}\n", what, in_seconds(measured),
                       simulated ? fmt::format("{:10.6f} s", *simulated) : "-", more);
}

std::string print_board_run(const SendOptions& options, std::size_t bytes, const iserver::BoardRun& run,
                            const std::optional<SimulatedTimes>& simulated) {
    const auto times = [&](double SimulatedTimes::*time) {
        return simulated ? std::optional(*simulated.*time) : std::nullopt;
    };
    std::string text =
        fmt::format("{} on {}: the program {}\n", options.file, options.to, print_end(run)) +
        painted(Paint::heading, fmt::format("{:<9}  {:>12}  {:>12}\n", "", "measured", "simulated")) +
        print_times("boot", run.boot_time, times(&SimulatedTimes::boot),
                    fmt::format("{} bytes, {:.0f} Kbyte/s measured", bytes,
                                static_cast<double>(bytes) / 1000 / std::max(in_seconds(run.boot_time), 1e-6))) +
        print_times("run", run.run_time, times(&SimulatedTimes::run), counted(run.requests, "request"));
    if (simulated)
        text += fmt::format(
            "simulated: a {} with {} of memory, each access of which takes {} cycles; the host takes no time\n",
            options.booted.processor, options.booted.memory, options.booted.memory_cycles);
    if (simulated && !simulated->departure.empty())
        text += fmt::format("the simulated program differs: {}\n", simulated->departure);
    return text;
}

ExitCode send(const SendOptions& options, const Options& typed) {
    const std::vector<std::uint8_t> file = read_bootable(options.file);
    const HostServices host = services_of(options.booted);
    InterruptedBySignals interruption;
    std::signal(SIGPIPE, SIG_IGN); // a board that closes the connection is reported
    const auto interrupted = [&interruption] { return interruption.requested(); };
    bool unread = false;
    iserver::BoardRun run;
    {
        const std::shared_ptr<iserver::Terminal> terminal = terminal_for(options.booted, interrupted, [&] {
            unread = true;
            interruption.request();
        })();
        iserver::Server server(server_options(host, options.file), *terminal);
        const iserver::OpenFile board = iserver::connect_board(options.to, interrupted);
        if (!board)
            return ExitCode::interrupted;
        const std::string_view program(reinterpret_cast<const char*>(file.data()), file.size());
        run = iserver::serve_board(program, board, options.to, server, interrupted);
    }
    print_out(print_board_run(options, file.size(), run, simulate(options, typed, run, interruption)));
    if (run.state == iserver::ServerState::running)
        return unread ? ExitCode::success : ExitCode::interrupted;
    return run.exit == 0 ? ExitCode::success : ExitCode::bad_input;
}

Action declare_send(Options& command, const std::string&) {
    auto options = std::make_shared<SendOptions>();
    command.add("FILE", options->file, "a bootable file").required().check(not_a_named_file);
    command.add("--to", options->to, "a character device, or tcp:HOST:PORT for a link adapter on a network")
        .type("BOARD")
        .required()
        .check(not_a_name);
    add_machine(command, options->booted, "The simulated transputer beside the board");
    add_host(command, options->booted, "The program's host");
    return [options, command] { return send(*options, command); };
}

} // namespace

extern const Command send_command{
    .name = "send",
    .about = "Boots a real transputer board with a file, and serves the requests of its program",
    .place = 46,
    .declare = declare_send,
};

} // namespace placedpar
