#include "netlist/complete/complete.hpp"
#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

const PortBinding* find_binding(const ProcessInstance& process, std::string_view port) {
    auto found = std::ranges::find_if(process.ports, [&](const PortBinding& binding) {
        return binding.port == port || base_name(binding.port) == port;
    });
    return found == process.ports.end() ? nullptr : &*found;
}

void check_together(Completion& c, const ProcessInstance& process, const std::vector<std::string>& ports) {
    const PortBinding* connected = nullptr;
    const std::string* left_out = nullptr;
    for (const auto& port : ports)
        if (const auto* binding = find_binding(process, port))
            connected = binding;
        else
            left_out = &port;
    if (connected == nullptr || left_out == nullptr)
        return;
    c.reporter.error(c.network.channels[connected->channel].connected,
                     fmt::format("the channel \"{0}.{1}\" is connected, but \"{0}.{2}\" is not", process.name,
                                 connected->port, *left_out),
                     fmt::format("the kind \"{}\" takes both or neither: connect {}.{} to ...;", process.kind,
                                 process.name, *left_out));
}

/// Where the netlist gives the parameter, connects the port, or else declares the process.
Location place_of(const Completion& c, const Complaint& complaint) {
    const auto& process = c.network.processes[complaint.process];
    if (auto given = process.given.find(complaint.about); given != process.given.end())
        return given->second;
    if (const auto* binding = find_binding(process, complaint.about))
        return c.network.channels[binding->channel].connected;
    return process.declared;
}

void report(Completion& c, const Complaint& complaint) {
    if (complaint.warning)
        c.reporter.warning(place_of(c, complaint), complaint.message, complaint.hint);
    else
        c.reporter.error(place_of(c, complaint), complaint.message, complaint.hint);
}

} // namespace

void complete_checks(Completion& c) {
    const auto& processes = c.network.processes;
    for (std::size_t i = 0; i < processes.size(); ++i)
        if (c.kinds[i] != nullptr)
            for (const auto& ports : c.kinds[i]->together)
                check_together(c, processes[i], ports);
    if (c.reporter.failed())
        return;
    for (std::size_t i = 0; i < processes.size(); ++i)
        if (c.kinds[i] != nullptr && c.kinds[i]->check)
            for (const auto& complaint : c.kinds[i]->check(c.network, i))
                report(c, complaint);
}

} // namespace placedpar
