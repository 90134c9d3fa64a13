#pragma once

#include "runtime/hardware/link_faults.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace placedpar {

struct ProcessorUse {
    std::string name;
    std::string type;
    Time busy;                  ///< how long it executed processes, waiting for its memory included
    Time memory_taken_by_links; ///< how long its memory served the engines of its links, while it was busy or not
    std::uint64_t packets_passed_on = 0; ///< of channels that lead through it
    Time passing_on{};                   ///< what that took of the time it was busy, without waiting for its memory
};

struct LinkUse {
    std::string from, to; ///< "t[0].link[3]"
    std::uint64_t bytes;
    Time occupied; ///< how long its wire carried their bits
};

/// A master's use of its bus.
struct BusMasterUse {
    std::string name;
    int level;
    std::uint64_t words, bytes; ///< words moved, registers accessed
    std::uint64_t grants, bus_errors;
    Time waited, longest_wait; ///< for the bus
};

/// Messages that were written once for several link adapters.
struct BroadcastUse {
    std::string from; ///< the port array: "host.to_masters"
    std::size_t adapters;
    std::uint64_t messages, bytes; ///< each counted once
};

struct BusUse {
    std::string name;
    Time busy; ///< how long it moved words or bytes
    std::vector<BusMasterUse> masters;
    std::vector<BroadcastUse> broadcasts;
};

/// What a fault of the machine did in the run.
struct FaultUse {
    std::string fault; ///< as a statement has it: "t[0].link[1] silent (from = 20ms)"
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    struct Hit {
        Time at;
        std::string channel;
        bool acknowledge;                                 ///< of the byte; else the byte itself
        std::uint64_t byte;                               ///< of the message, from 1
        hardware::FaultEffect::Hit::Message message = {}; ///< or a packet
    };
    std::optional<Hit> first, last;            ///< that it struck, and that it lost
    std::vector<std::string> stopped_channels; ///< of those that travel in packets: they wait for ever because of it
    std::vector<std::string> stopped;          ///< processes that were not at their end when their processor halted
    std::optional<Time> held_since;            ///< when a bus was granted to the master that hogs it
    std::uint64_t bus_errors = 0;              ///< accesses that what is absent did not answer

    bool had_effect() const {
        return first || held_since || bus_errors > 0 || !stopped.empty() || !stopped_channels.empty();
    }
};

/// What a switch that a program sets did in the run.
struct SwitchUse {
    std::string name;
    std::uint64_t commands = 0, connections = 0; ///< obeyed; made, one for each output
    /// Counts the messages that it did not lead on.
    struct Loss {
        std::string from, to; ///< the links
        std::uint64_t bytes = 0, acknowledges = 0;
        FaultUse::Hit first;
        int output;        ///< that should have led the first of them on
        std::string state; ///< what it did then: "was connected to no input"
    };
    std::vector<Loss> losses;
};

/// Tells what a device of another kind reports, as a table.
struct DeviceUse {
    std::string title;                ///< "ring r"
    Time busy;                        ///< how long it carried something
    std::vector<std::string> columns; ///< the first heads the names of the rows
    struct Row {
        std::string name;
        std::vector<std::variant<std::uint64_t, Time>> figures; ///< one below each other column
    };
    std::vector<Row> rows;
};

/// Tells how a run used the machine: each device adds what it reports (MachineNode::report).
struct MachineUse {
    std::vector<ProcessorUse> processors;
    std::vector<LinkUse> links;
    std::vector<BusUse> buses;
    std::vector<SwitchUse> switches; ///< that programs set
    std::vector<DeviceUse> devices;
};

} // namespace placedpar
