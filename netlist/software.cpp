#include "netlist/software.hpp"

#include "netlist/network/names.hpp"
#include "netlist/runnable.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/timer.hpp"
#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace placedpar {

namespace {

/// REQUIRES: the network can be run.
const ProcessKind& kind_of(const ProcessInstance& process, const Catalogue& catalogue) {
    return *catalogue.find(process.kind);
}

const PortDescription& port_of(const ProcessInstance& process, std::string_view name, const Catalogue& catalogue) {
    return *kind_of(process, catalogue).port(base_name(name));
}

/// Which process it was, and when if not at the start.
std::string failing(const ProcessInstance& process) {
    std::string when = now() == Time{0} ? "" : " at " + to_string(now());
    return fmt::format("process {} ({}){}", process.name, process.kind, when);
}

/// The same, and where it was declared.
std::string failure_of(const ProcessInstance& process, const char* why) {
    std::string place = process.declared.text();
    return fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ", failing(process), why);
}

/// Runs a process's program. What it refuses to work with, and what is wrong with the program itself, is reported with
/// the process, after a file's own places; what the system refuses is not the process's fault.
void run_body(const ProcessInstance& process, const std::function<void(ProcessEnvironment&)>& body,
              ProcessEnvironment& environment) {
    try {
        body(environment);
    } catch (const RefusedInput& refused) {
        throw RefusedInput(refused.what() + render(SecondPlace{"read by " + failing(process), process.declared}));
    } catch (const UserError& refused) {
        throw UserError(failure_of(process, refused.what()));
    } catch (const hardware::BusError& error) { // of a machine with a fault, which the program does not provide for
        throw UserError(failure_of(process, error.what()));
    } catch (const std::system_error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& defect) {
        throw std::logic_error(failure_of(process, defect.what()));
    }
}

} // namespace

Software::Software(const Network& network, const Catalogue& catalogue, std::uint64_t seed)
    : network_(network), catalogue_(catalogue), seed_(seed) {
    require_runnable(network, catalogue);
    for (const NetworkChannel& channel : network.channels) {
        const ProcessInstance& sender = network.processes[channel.from.process];
        channels_.push_back(port_of(sender, channel.from.port, catalogue).make_channel(channel.name));
    }
}

void Software::start(Simulation& simulation, const std::vector<Executive*>& executives) {
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        processes_.push_back(&start(simulation, i, executives[network_.processes[i].node]));
    expect_partners();
}

void Software::expect_partners() {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        channels_[i]->expect_outputter(*processes_[network_.channels[i].from.process]);
        channels_[i]->expect_inputter(*processes_[network_.channels[i].to.process]);
    }
}

Process& Software::start(Simulation& simulation, std::size_t index, Executive* executive) {
    const ProcessInstance& process = network_.processes[index];
    std::vector<ProcessEnvironment::Port> ports;
    for (const PortBinding& binding : process.ports)
        ports.push_back({binding.port, channels_[binding.channel].get()});
    ProcessEnvironment& environment =
        environments_.emplace_back(network_, index, std::move(ports), seed_, measurements_);
    return simulation.process(
        process.name,
        [&process, &environment, body = kind_of(process, catalogue_).body] { run_body(process, body, environment); },
        executive, process.high_priority ? Priority::high : Priority::low);
}

} // namespace placedpar
