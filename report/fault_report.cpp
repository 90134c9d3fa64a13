#include "report/fault_report.hpp"

#include "text/counted.hpp"
#include "text/paint.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <utility>

namespace placedpar {

namespace {

using MessageStruck = hardware::FaultEffect::Hit::Message;

const char* what_was_struck(MessageStruck message) {
    switch (message) {
    case MessageStruck::whole: return "a message on";
    case MessageStruck::packet: return "a packet of";
    case MessageStruck::acknowledging_packet: return "a packet that acknowledges a packet of";
    }
    return "";
}

std::string print_hit(const FaultUse::Hit& hit) {
    return fmt::format("at {}: {}byte {} of {} channel {}", to_string(hit.at),
                       hit.acknowledge ? "the acknowledge of " : "", hit.byte, what_was_struck(hit.message),
                       hit.channel);
}

/// Prints the fault's effects, with the first and the last loss. The last loss may have caused a deadlock.
std::string print_effect(const FaultUse& fault) {
    std::vector<std::string> said;
    if (fault.last)
        said.push_back(fmt::format("lost {} and {}", counted(fault.bytes_lost, "byte"),
                                   counted(fault.acknowledges_lost, "acknowledge")));
    if (!fault.stopped.empty())
        said.push_back(fmt::format("stopped {}", fmt::join(fault.stopped, ", ")));
    if (!fault.stopped_channels.empty())
        said.push_back(fmt::format("stopped the {} {}", fault.stopped_channels.size() > 1 ? "channels" : "channel",
                                   fmt::join(fault.stopped_channels, ", ")));
    if (fault.bus_errors > 0)
        said.push_back(counted(fault.bus_errors, "bus error"));
    if (fault.held_since)
        said.push_back(fmt::format("held the bus from {} on", to_string(*fault.held_since)));
    std::string out = said.empty() ? fault.had_effect() ? "slowed messages down" : "had no effect"
                                   : fmt::format("{}", fmt::join(said, "; "));
    if (fault.first)
        out += fmt::format("\n    first {}", print_hit(*fault.first));
    if (fault.last && fault.first && fault.last->at != fault.first->at)
        out += fmt::format("\n    last {}", print_hit(*fault.last));
    return out;
}

std::string print_loss(const SwitchUse::Loss& loss, const std::string& name) {
    return fmt::format("  {} -> {}: lost {} and {}\n    first {}\n    output {} of {} {}\n", loss.from, loss.to,
                       counted(loss.bytes, "byte"), counted(loss.acknowledges, "acknowledge"), print_hit(loss.first),
                       loss.output, name, loss.state);
}

const char* what_was_struck_json(MessageStruck message) {
    switch (message) {
    case MessageStruck::whole: return "message";
    case MessageStruck::packet: return "packet";
    case MessageStruck::acknowledging_packet: return "acknowledging_packet";
    }
    return "";
}

boost::json::value hit_json(const std::optional<FaultUse::Hit>& hit) {
    if (!hit)
        return nullptr;
    return {{"time_ps", hit->at.count()},
            {"channel", hit->channel},
            {"what", hit->acknowledge ? "acknowledge" : "byte"},
            {"byte", hit->byte},
            {"of", what_was_struck_json(hit->message)}};
}

boost::json::object loss_json(const SwitchUse::Loss& loss) {
    return {{"from", loss.from},
            {"to", loss.to},
            {"bytes_lost", loss.bytes},
            {"acknowledges_lost", loss.acknowledges},
            {"first", hit_json(loss.first)},
            {"output", loss.output},
            {"state", loss.state}};
}

} // namespace

std::string print_faults(const std::vector<FaultUse>& faults) {
    std::string out = faults.empty() ? "" : painted(Paint::heading, "\nfaults\n");
    for (const FaultUse& fault : faults)
        out += fmt::format("  {}: {}\n", fault.fault, print_effect(fault));
    return out;
}

std::string print_switches(const std::vector<SwitchUse>& switches) {
    std::string out;
    for (const SwitchUse& each : switches) {
        out +=
            painted(Paint::heading, fmt::format("\nswitch {}", each.name)) +
            fmt::format(": {}, {} made\n", counted(each.commands, "command"), counted(each.connections, "connection"));
        for (const SwitchUse::Loss& loss : each.losses)
            out += print_loss(loss, each.name);
    }
    return out;
}

boost::json::object json_of_fault(const FaultUse& fault) {
    return {{"fault", fault.fault},
            {"had_effect", fault.had_effect()},
            {"bytes_lost", fault.bytes_lost},
            {"acknowledges_lost", fault.acknowledges_lost},
            {"first", hit_json(fault.first)},
            {"last_lost", hit_json(fault.last)},
            {"stopped", boost::json::value_from(fault.stopped)},
            {"stopped_channels", boost::json::value_from(fault.stopped_channels)},
            {"bus_errors", fault.bus_errors},
            {"held_since_ps", fault.held_since ? boost::json::value(fault.held_since->count()) : nullptr}};
}

boost::json::object json_of_switch(const SwitchUse& use) {
    boost::json::array losses;
    for (const SwitchUse::Loss& loss : use.losses)
        losses.push_back(loss_json(loss));
    return {{"name", use.name},
            {"commands", use.commands},
            {"connections", use.connections},
            {"losses", std::move(losses)}};
}

} // namespace placedpar
