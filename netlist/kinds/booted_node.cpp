#include "netlist/kinds/booted_node.hpp"

#include "iserver/terminal.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "netlist/kinds/memory_access.hpp"
#include "netlist/kinds/outside_host.hpp"
#include "runtime/kernel.hpp"
#include "runtime/transputer/code_text.hpp"
#include "runtime/transputer/core_text.hpp"
#include "runtime/transputer/error_text.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

transputer::CoreTiming timing_of(const Node& node) {
    return {.clock_hz = node.integer("clock"),
            .memory_cycles = static_cast<int>(static_cast<std::int64_t>(access_time(node))),
            .switch_cycles = static_cast<int>(node.integer("switching")),
            .wraps = node.integer("wraps") != 0};
}

/// Returns whether a host in the network answers requests of a program.
bool serves_a_program(const Network& network) {
    for (std::size_t i = 0; i < network.nodes.size(); ++i)
        if ((network.nodes[i].image || !network.nodes[i].boot_file.empty()) && link_to_host(network, i))
            return true;
    return false;
}

std::shared_ptr<iserver::Terminal> terminal_of(const HostServices& host) {
    if (host.terminal)
        return host.terminal();
    return std::make_shared<iserver::ScriptedTerminal>("", [](std::string_view) {});
}

} // namespace

iserver::ServerOptions server_options(const HostServices& host, const std::string& file) {
    iserver::ServerOptions options;
    options.host_folder = host.folder;
    options.command_line = host.command_line;
    options.whole_command_line = host.command_line.empty() ? file : file + " " + host.command_line;
    options.environment = {host.environment.begin(), host.environment.end()};
    options.write_limit_bytes = host.write_limit_bytes;
    return options;
}

namespace {

/// Returns the options of the node's host. Programs made by INMOS's tools read the size of their memory from the
/// environment variable IBOARDSIZE.
iserver::ServerOptions options_of(const HostServices& host, const Node& node) {
    iserver::ServerOptions options = server_options(host, node.boot_file);
    options.environment.emplace("IBOARDSIZE", fmt::format("#{:X}", node.integer("memory")));
    return options;
}

} // namespace

/// Holds the parts of the simulated host that boots the node: the terminal, the server, and the host's end of the link.
struct BootedNode::Host {
    Host(const Network& network, const Node& node)
        : terminal(terminal_of(network.host)), server(options_of(network.host, node), *terminal),
          end(node.image ? std::vector<std::uint8_t>{} : *node.boot_bytes, answering(network.host),
              Time{1000 * node.integer("hosttime")}) {}

    Answering answering(const HostServices& services) {
        if (services.answers)
            return services.answers;
        return [this](iserver::ByteView request, std::chrono::microseconds now) { return server.answer(request, now); };
    }

    std::shared_ptr<iserver::Terminal> terminal;
    iserver::Server server;
    BootHost end;
};

BootedNode::BootedNode(MachineParts& parts, std::size_t index)
    : MachineNode(parts, index),
      device_(simulation().add<transputer::Node>(node().name, *transputer::model_named(node().type),
                                                 static_cast<std::uint64_t>(node().integer("memory")),
                                                 timing_of(node()))) {
    device_.name_by(lines());
    device_.when_stopped([this] {
        tell_hosts();
        notice_end();
    });
    watch_code();
    if (!node().image)
        return;
    device_.start(*node().image);
    if (network().processes.empty() && !serves_a_program(network()))
        await_end();
}

/// Makes the node count its instructions, or lets the user execute them one by one, if the user has asked for this.
void BootedNode::watch_code() {
    if (network().host.lists_code)
        listing_ = std::make_unique<transputer::Listing>(device_.core());
    if (network().host.steps && !node().boot_file.empty())
        stepper_ = std::make_unique<transputer::Stepper>(device_.core(), lines(), *network().host.steps,
                                                         [](std::string_view text) { print_out(std::string(text)); });
}

BootedNode::~BootedNode() = default;

/// Makes a process that waits until all processes of the image, the program in the node's memory, have ended. Otherwise
/// the run could end too early, since a run ends when the processes of the simulation have ended.
void BootedNode::await_end() {
    device_.when_idle([this] { notice_end(); });
    simulation().process("the code of " + node().name, [this] {
        if (has_ended())
            return;
        awaits_end_ = &Kernel::here().running();
        awaits_end_->wait_for(Activity::inputting, nullptr, {});
    });
}

bool BootedNode::has_ended() const {
    const transputer::Node::Activity activity = device_.activity();
    return activity != transputer::Node::Activity::booted || device_.has_ended(*node().image);
}

void BootedNode::notice_end() {
    if (!awaits_end_ || !has_ended())
        return;
    Process& waiting = *std::exchange(awaits_end_, nullptr);
    waiting.kernel().make_ready(waiting);
}

void BootedNode::has_link(hardware::Link& link) {
    const auto known = std::ranges::find(parts().links, &link);
    const LinkConnection& wire = network().connections[static_cast<std::size_t>(known - parts().links.begin())];
    device_.has_link(link);
    const bool is_second_end = wire.a.node == index() && std::exchange(last_link_, &link) == &link;
    const bool own_is_b = wire.a.node != index() || is_second_end;
    const LinkEnd &own = own_is_b ? wire.b : wire.a, &other = own_is_b ? wire.a : wire.b;
    if (other.at_edge())
        return connect_host(link, own, !own_is_b);
    auto* partner = dynamic_cast<BootedNode*>(parts().nodes[other.node].get());
    if (partner && own_is_b) // each wire is connected once
        lanes_.push_back(
            std::make_unique<transputer::ByteLink>(link, partner->device_.end(other.link), device_.end(own.link)));
}

/// Connects the host of a node that is booted with a file, or that has an image. A node has one host: at further links
/// that lead to edges, nothing is connected.
void BootedNode::connect_host(hardware::Link& link, const LinkEnd& own, bool own_is_a) {
    if ((node().boot_file.empty() && !node().image) || host_ || outside_)
        return;
    auto& here = device_.end(own.link);
    const auto connect = [&](transputer::ByteEnd& host) {
        lanes_.push_back(own_is_a ? std::make_unique<transputer::ByteLink>(link, here, host)
                                  : std::make_unique<transputer::ByteLink>(link, host, here));
    };
    if (iserver::OfferedBoard* board = network().host.board) {
        outside_ = std::make_unique<OutsideHost>(*board);
        connect(*outside_);
        simulation().process("host", [this] { outside_->serve(); });
        return;
    }
    host_ = std::make_unique<Host>(network(), node());
    connect(host_->end);
    simulation().process("host", [this] {
        host_->end.serve();
        host_->server.finish();
    });
}

/// Returns the far end of the wire, at which processes of the netlist output and input messages.
transputer::MessageEnd& BootedNode::message_end(std::size_t connection) {
    auto [found, added] = message_ends_.try_emplace(connection, node().name);
    if (added) {
        const LinkConnection& wire = network().connections[connection];
        transputer::MessageEnd& there = found->second;
        hardware::Link& link = *parts().links[connection];
        lanes_.push_back(wire.a.node == index()
                             ? std::make_unique<transputer::ByteLink>(link, device_.end(wire.a.link), there)
                             : std::make_unique<transputer::ByteLink>(link, there, device_.end(wire.b.link)));
    }
    return found->second;
}

void BootedNode::carry(AnyChannel& channel, const RouteHop& hop) {
    transputer::MessageEnd& end = message_end(hop.connection);
    if (end_of(hop, network().connections).node == index())
        end.carry_outputs(channel);
    else
        end.carry_inputs(channel);
}

/// Ends the work of all hosts: a transputer has set its error pin, which every host of the network sees.
void BootedNode::tell_hosts() {
    for (const auto& each : parts().nodes) {
        const auto* booted = dynamic_cast<BootedNode*>(each.get());
        if (booted && booted->host_)
            booted->host_->end.abandon();
        if (booted && booted->outside_)
            booted->outside_->abandon();
    }
}

void BootedNode::shuffle(std::uint64_t seed) { device_.core().shuffle(RandomStream(seed, node().name)); }

FaultEffects BootedNode::suffer(const Fault& halts) {
    device_.halt_at(begin_of(halts));
    return [this](FaultUse& use) {
        if (device_.activity() == transputer::Node::Activity::halted)
            use.stopped.push_back("the code of " + node().name);
    };
}

namespace {

/// Returns why a core has stopped, and at which place in the source, if the place is known.
std::string stop_of(const transputer::Core& core, const transputer::CodeLines& lines) {
    const bool is_behind = core.stopped() == transputer::Stopped::by_break;
    const std::string place = lines.file_place(core.registers().instruction - (is_behind ? 1 : 0));
    return (place.empty() ? "stopped: " : fmt::format("stopped at {}: ", place)) + core.why_stopped();
}

/// Describes the error that has halted a core: its place, cause, process and time.
std::string halt_of(const transputer::Core& core, const transputer::CodeLines& lines) {
    const transputer::ErrorNote error = error_to_name(core, core.error(), lines);
    const std::string place = lines.file_place(error.after - 1), process = lines.process(error.workspace),
                      time = to_string(core.local_time());
    if (place.empty())
        return fmt::format("stopped at {}: {}; {}", time, print_error(core, error, lines), core.why_stopped());
    return fmt::format("stopped at {}: {}{}, at {}", place, print_error(core, error, lines),
                       process.empty() ? "" : ", in " + process, time);
}

} // namespace

std::string BootedNode::state() const {
    const std::string limit =
        host_ && host_->server.exceeded_write_limit() ? "; it reached the limit of --host-limit" : "";
    return state_of_program() + limit;
}

std::string BootedNode::state_of_program() const {
    if (device_.activity() == transputer::Node::Activity::halted)
        return "halted by a fault";
    if (device_.activity() == transputer::Node::Activity::listening)
        return "was never booted";
    if (device_.activity() == transputer::Node::Activity::stopped)
        return device_.core().stopped() == transputer::Stopped::by_error ? halt_of(device_.core(), lines())
                                                                         : stop_of(device_.core(), lines());
    if (host_ && !host_->end.refusal().empty())
        return "sent bytes that are not a request: " + host_->end.refusal();
    if (host_ && host_->end.state() == iserver::ServerState::waits_for_input)
        return "waits for a key, but the input has ended";
    if (host_ && host_->end.state() == iserver::ServerState::exited)
        return host_->end.exit_status() == 0   ? "exited with success"
               : host_->end.exit_status() == 1 ? "exited with failure"
                                               : fmt::format("exited with status {}", host_->end.exit_status());
    if (outside_)
        return "was served by another program";
    if (!device_.is_idle())
        return "runs";
    if (host_ && host_->server.was_out_of_keys())
        return "waits; an earlier request for a key found no key";
    return host_ && waiting_processes().empty()
               ? "has no process left, and did not tell the host to exit (so.exit in occam)"
               : "waits";
}

const transputer::CodeLines& BootedNode::lines() const {
    static const transputer::CodeLines none;
    if (node().image && node().image->lines)
        return *node().image->lines;
    return node().code_lines ? *node().code_lines : none;
}

namespace {

/// Returns whether a process waits for ever in an ALT in which no guard has a true condition.
bool never_goes_on(const transputer::WaitingProcess& process) {
    return process.wait == transputer::Wait::alternative && process.channels.empty() && !process.time;
}

} // namespace

/// Returns the waiting processes, except processes that only pass on messages of other processes.
std::vector<transputer::WaitingProcess> BootedNode::waiting_processes() const {
    std::vector<transputer::WaitingProcess> waiting = transputer::waiting_processes(device_.core());
    std::erase_if(waiting, [&](const auto& each) { return lines().is_carrier(each.workspace); });
    return waiting;
}

ProgramWait BootedNode::describe(const transputer::WaitingProcess& process) const {
    using transputer::Wait;
    constexpr Activity activities[] = {Activity::inputting, Activity::outputting, Activity::alternating,
                                       Activity::delayed};
    const transputer::Instruction& waits = transputer::description_of(
        transputer::instruction_before(device_.core(), process.instruction).instruction.operation);
    const std::string place = lines().place(process.instruction - 1);
    ProgramWait result{{device_.name_of_process(process.workspace),
                        activities[static_cast<std::size_t>(process.wait)],
                        {},
                        place.empty()
                            ? fmt::format("{} after {}", transputer::print_address(process.instruction), waits.name)
                            : place},
                       {},
                       {}};
    for (const transputer::Word channel : process.channels) {
        result.process.channels.push_back(device_.name_of_channel(channel));
        result.awaited.push_back({device_.name_of_channel(channel), process.wait != Wait::output});
    }
    if (never_goes_on(process))
        result.process.channels.emplace_back("no guard of this ALT is true");
    if (process.time)
        result.process.channels.push_back(fmt::format("timer, after {}", static_cast<std::int32_t>(*process.time)));
    return result;
}

std::vector<ProgramWait> BootedNode::program_waits() const {
    constexpr std::size_t most_copied_in_all = std::size_t{1} << 30;
    if (device_.activity() != transputer::Node::Activity::booted)
        return {};
    const std::vector<transputer::WaitingProcess> waiting = waiting_processes();
    const std::size_t bytes = device_.core().memory().size();
    const bool looks_ahead = bytes <= transputer::most_copied_bytes && bytes * waiting.size() <= most_copied_in_all;
    std::vector<ProgramWait> result;
    for (const transputer::WaitingProcess& each : waiting) {
        result.push_back(describe(each));
        if (!looks_ahead || never_goes_on(each))
            continue;
        for (const transputer::ChannelEnd& end : transputer::ends_ahead(device_.core(), each))
            result.back().ahead.push_back({device_.name_of_channel(end.channel), end.is_output});
    }
    return result;
}

std::vector<ProgramUse::Stop> BootedNode::stops() const {
    const transputer::Core& core = device_.core();
    std::vector<ProgramUse::Stop> result;
    for (const transputer::Core::StoppedProcess& each : core.stopped_processes()) {
        const transputer::ErrorNote error = error_to_name(core, each.error, lines());
        result.push_back({device_.name_of_process(error.workspace), lines().place(error.after - 1),
                          print_error(core, error, lines()), each.at});
    }
    return result;
}

void BootedNode::report(MachineUse& use) const {
    const bool exited_badly =
        host_ && host_->end.state() == iserver::ServerState::exited && host_->end.exit_status() == 1;
    const bool sent_no_request = host_ && !host_->end.refusal().empty();
    const bool stopped =
        device_.activity() == transputer::Node::Activity::stopped || device_.core().count_stopped() > 0;
    use.programs.push_back({.name = node().name,
                            .instructions = device_.core().instructions(),
                            .requests = host_ ? host_->end.requests() : 0,
                            .state = state(),
                            .listing = listing_ ? print_listing(*listing_, lines()) : "",
                            .analysis = network().host.analyses ? print_analysis(device_.core(), lines()) : "",
                            .failed = exited_badly || sent_no_request || stopped,
                            .halted = stopped && device_.core().stopped() == transputer::Stopped::by_error,
                            .booted_at = host_ ? host_->end.booted_at() : Time{},
                            .stops = stops(),
                            .count_of_stops = device_.core().count_stopped()});
    use.processors.push_back({node().name, node().type, device_.time_busy(), device_.memory_taken_by_links()});
}

} // namespace placedpar
