#include "netlist/failed_process.hpp"

#include "netlist/network/names.hpp"
#include "runtime/byte_form.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/user_code.hpp"
#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>

namespace placedpar {

namespace {

/// Returns "farm.cfs:12"; "" if there is no file.
std::string file_and_line(const Location& location) {
    if (!location.file)
        return "";
    return fmt::format("{}:{}", std::filesystem::path(location.file->path()).filename().string(), location.line);
}

/// Returns the process of the netlist for a path such as "a/1", which means component 1 of a PAR in process a. Returns
/// null if the network has no such process.
const ProcessInstance* outermost(const Network& network, std::string_view path) {
    return find_named(network.processes, path.substr(0, path.find('/')));
}

} // namespace

void add_places(Deadlock& deadlock, const Network& network) {
    for (StuckProcess& stuck : deadlock.processes)
        if (const ProcessInstance* process = outermost(network, stuck.path))
            stuck.netlist = file_and_line(process->declared);
    std::unordered_map<std::string_view, std::size_t> places;
    for (const NetworkChannel& channel : network.channels)
        places.emplace(channel.name, places.size());
    auto place_of = [&](const StuckChannel& stuck) {
        auto found = places.find(stuck.name);
        return found == places.end() ? network.channels.size() : found->second;
    };
    std::ranges::stable_sort(deadlock.channels, {}, place_of);
    for (StuckChannel& stuck : deadlock.channels)
        if (std::size_t place = place_of(stuck); place < network.channels.size())
            stuck.netlist = file_and_line(network.channels[place].connected);
}

namespace {

/// Returns a text such as "process a/1 (kind) at 3 us". The time is left out if it is 0.
std::string failing(const Failure& failure, const ProcessInstance* process) {
    return fmt::format("process {}{}{}", failure.process, process ? " (" + process->kind + ")" : "",
                       failure.time == Time{0} ? "" : " at " + to_string(failure.time));
}

/// Returns whether the network has a device that a user's program defines. An exception in a process may then come from
/// the device that carries its messages.
bool has_own_devices(const Network& network) {
    return std::ranges::any_of(network.nodes, [](const Node& node) { return node.kind->is_own; });
}

} // namespace

void rethrow_with_process(const Failure& failure, const Network& network, const Catalogue& catalogue) {
    const ProcessInstance* process = outermost(network, failure.process);
    const bool is_own = (process && catalogue.find(process->kind)->is_own) || has_own_devices(network);
    std::string place = process ? process->declared.text() : "";
    std::string who = fmt::format("{}{}{}", place, place.empty() ? "" : ": ", failing(failure, process));
    try {
        throw;
    } catch (const RefusedInput& refused) {
        if (!process)
            throw;
        throw RefusedInput(refused.what() +
                           render(SecondPlace{"read by " + failing(failure, process), process->declared}));
    } catch (const hardware::BroadcastError& refused) {
        throw UserError(fmt::format("{}: {}\nhint: all channels of a broadcast carry the same messages; do not place a "
                                    "channel with other messages on the bus",
                                    who, refused.what()));
    } catch (const UserError& refused) {
        throw UserError(fmt::format("{}: {}", who, refused.what()));
    } catch (const NoMessage& received) {
        throw UserError(fmt::format("{}: {}", who, received.what()));
    } catch (const hardware::BusError& error) { // the program does not handle a fault of the machine
        throw UserError(fmt::format("{}: {}", who, error.what()));
    } catch (...) {
        const std::string why = what_was_thrown();
        if (is_own)
            throw UserError(fmt::format("{}: {}", who, why));
        try {
            throw;
        } catch (const std::system_error&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (...) {
            throw std::logic_error(fmt::format("{}: {}", who, why));
        }
    }
}

} // namespace placedpar
