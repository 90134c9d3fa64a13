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
    Time busy;                  ///< time spent executing processes, including waits for the processor's memory
    Time memory_taken_by_links; ///< time in which the memory served the link engines, whether the processor was busy or
                                ///< not
    std::uint64_t packets_passed_on = 0; ///< packets of channels that lead through the processor
    Time passing_on{};                   ///< part of `busy` spent on passing packets on, without waits for memory
};

struct LinkUse {
    std::string from, to; ///< "t[0].link[3]"
    std::uint64_t bytes;
    Time occupied; ///< time for which the wire carried bits
};

/// Reports a master's use of its bus.
struct BusMasterUse {
    std::string name;
    int level;
    std::uint64_t words, bytes; ///< words moved over the bus; bytes accessed in registers
    std::uint64_t grants, bus_errors;
    Time waited, longest_wait; ///< waiting times for the bus
};

/// Counts messages that were written once for several link adapters.
struct BroadcastUse {
    std::string from; ///< the port array: "host.to_masters"
    std::size_t adapters;
    std::uint64_t messages, bytes; ///< each message is counted once
};

struct BusUse {
    std::string name;
    Time busy; ///< time for which the bus moved words or bytes
    std::vector<BusMasterUse> masters;
    std::vector<BroadcastUse> broadcasts;
};

/// Reports what a fault of the machine did in the run.
struct FaultUse {
    std::string fault; ///< the fault as a statement: "t[0].link[1] silent (from = 20ms)"
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    struct Hit {
        Time at;
        std::string channel;
        bool acknowledge;   ///< true if the fault hit the acknowledge; false if it hit the byte itself
        std::uint64_t byte; ///< number of the byte in its message, from 1
        hardware::FaultEffect::Hit::Message message = {}; ///< the message, or packet, that was hit
    };
    std::optional<Hit> first, last;            ///< first and last hit
    std::vector<std::string> stopped_channels; ///< channels that wait for ever because the fault stopped their packets
    std::vector<std::string> stopped;          ///< processes that had not ended when their processor halted
    std::optional<Time> held_since;            ///< time at which the hogging master got the bus
    std::uint64_t bus_errors = 0;              ///< accesses that the absent device did not answer

    bool had_effect() const {
        return first || held_since || bus_errors > 0 || !stopped.empty() || !stopped_channels.empty();
    }
};

/// Reports the work of a switch that a program sets.
struct SwitchUse {
    std::string name;
    std::uint64_t commands = 0, connections = 0; ///< commands obeyed; connections made, one for each output
    /// Counts the bytes and acknowledges that the switch lost between two links.
    struct Loss {
        std::string from, to; ///< the links
        std::uint64_t bytes = 0, acknowledges = 0;
        FaultUse::Hit first;
        int output;        ///< the output that did not forward the first lost byte or acknowledge
        std::string state; ///< state of the output at that time: "was connected to no input"
    };
    std::vector<Loss> losses;
};

/// Holds the report of a device of another kind, as a table.
struct DeviceUse {
    std::string title;                ///< "ring r"
    Time busy;                        ///< time for which the device carried something
    std::vector<std::string> columns; ///< headings; the first is the heading of the row names
    struct Row {
        std::string name;
        std::vector<std::variant<std::uint64_t, Time>> figures; ///< one figure for each column but the first
    };
    std::vector<Row> rows;
};

/// Reports a transputer that executed its own code.
struct ProgramUse {
    std::string name; ///< name of the transputer
    std::uint64_t instructions = 0;
    std::uint64_t requests = 0; ///< requests to its host
    std::string state;          ///< "exited with success", "was never booted"
    std::string listing = "";   ///< the code that was executed; "" if it was not counted
    std::string analysis = "";  ///< the state of the transputer at the end; "" if it was not requested
    bool failed = false;        ///< the program exited with failure, or the transputer stopped
    bool halted = false;        ///< an error of the program has halted the transputer
    Time booted_at{};           ///< when the host had sent the bootable file
    /// Describes a process that an error stopped, while other processes continued.
    struct Stop {
        std::string process;
        std::string place; ///< place in the source, such as "ring.occ:12:3"
        std::string error; ///< "division by zero: 1 / 0"
        Time at;
    };
    std::vector<Stop> stops{};        ///< the first few processes that errors stopped
    std::uint64_t count_of_stops = 0; ///< number of all processes that errors stopped
};

/// Reports how a run used the machine. Each device adds its part (MachineNode::report).
struct MachineUse {
    std::vector<ProcessorUse> processors;
    std::vector<LinkUse> links;
    std::vector<BusUse> buses;
    std::vector<SwitchUse> switches; ///< switches that programs set
    std::vector<DeviceUse> devices;
    std::vector<ProgramUse> programs; ///< transputers that execute their own code
};

} // namespace placedpar
