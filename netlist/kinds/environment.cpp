#include "netlist/kinds/environment.hpp"

#include "netlist/network/network.hpp"
#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

ProcessEnvironment::ProcessEnvironment(const Network& network, std::size_t index, std::vector<Port> ports,
                                       std::uint64_t seed, std::vector<Measurement>& measurements)
    : network_(network), index_(index), process_(network.processes[index].name),
      parameters_(network.processes[index].parameters), ports_(std::move(ports)), seed_(seed),
      measurements_(measurements) {}

namespace {

/// Records a measurement in the history of a process. From the histories, a run can be repeated with another seed. If a
/// component of a PAR makes a measurement, the run cannot be repeated, since a history does not record the order of
/// components.
void note(const Process& self, const Measurement& measurement, ReplayLog& history) {
    if (self.parent())
        history.record_unrepeatable();
    else
        history.record_quietly(ReplayLog::Action::measurement, std::hash<std::string>()(measurement.name));
}

} // namespace

void ProcessEnvironment::throw_no_parameter(std::string_view parameter) const {
    throw std::logic_error(
        fmt::format("process {} has no parameter {} of the type that its code asks for", process_, parameter));
}

void ProcessEnvironment::throw_other_protocol(const AnyChannel& channel) const {
    throw std::logic_error(fmt::format("process {}: channel {} has another protocol than the process's code asks for",
                                       process_, channel.name()));
}

void ProcessEnvironment::add(Measurement measurement) {
    const Process* self = Kernel::current() ? Kernel::current()->who_runs() : nullptr;
    if (ReplayLog* history = self ? self->history() : nullptr)
        note(*self, measurement, *history);
    measurements_.push_back(std::move(measurement));
}

AnyChannel* ProcessEnvironment::find(std::string_view port) const {
    for (const Port& candidate : ports_)
        if (candidate.name == port)
            return candidate.channel;
    return nullptr;
}

AnyChannel& ProcessEnvironment::require(std::string_view port) const {
    if (AnyChannel* channel = find(port))
        return *channel;
    if (connected(port))
        throw UserError(
            fmt::format("\"{}\" is a single channel of this kind, not an array: connect it without a subscript", port));
    throw std::logic_error(fmt::format("process {} has no port {}", process_, port));
}

std::vector<AnyChannel*> ProcessEnvironment::all(std::string_view port) const {
    if (AnyChannel* channel = find(port))
        return {channel};
    std::vector<AnyChannel*> channels;
    for (std::size_t i = 0; AnyChannel* channel = find(fmt::format("{}[{}]", port, i)); ++i)
        channels.push_back(channel);
    return channels;
}

} // namespace placedpar
