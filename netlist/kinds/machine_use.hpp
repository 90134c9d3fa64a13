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
    Time busy;                  ///< time for which the processor executed processes, including waits for its memory
    Time memory_taken_by_links; ///< time in which the memory served the links, whether the processor was busy or not
    std::uint64_t packets_passed_on = 0; ///< number of packets that the processor passed on between other processors
    Time passing_on{}; ///< part of `busy` in which the processor passed packets on, without waits for memory
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
    std::uint64_t words,
        bytes; ///< `words` moved over the bus; `bytes` read from and written to registers of link adapters
    std::uint64_t grants, bus_errors;
    Time waited, longest_wait; ///< total and longest time between a request of the bus and its grant
};

/// Counts the messages of a broadcast: each message is written once on a bus and reaches several link adapters.
struct BroadcastUse {
    std::string from; ///< the sending port array, such as "host.to_masters"
    std::size_t adapters;
    std::uint64_t messages, bytes; ///< each message is counted once, however many adapters it reaches
};

struct BusUse {
    std::string name;
    Time busy; ///< time for which the bus moved words or bytes
    std::vector<BusMasterUse> masters;
    std::vector<BroadcastUse> broadcasts;
};

/// Reports what a fault that the netlist states, such as a silent link, did in the run.
struct FaultUse {
    std::string fault; ///< the fault as a statement: "t[0].link[1] silent (from = 20ms)"
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    struct Hit {
        Time at;
        std::string channel;
        bool acknowledge;   ///< true if the fault hit the acknowledge; false if it hit the byte itself
        std::uint64_t byte; ///< position of the byte in its message, from 1
        hardware::FaultEffect::Hit::Message message = {}; ///< the message, or packet, that was hit
    };
    std::optional<Hit> first, last; ///< first and last byte or acknowledge that the fault hit
    std::vector<std::string>
        stopped_channels; ///< channels whose processes wait for ever, because the fault stopped their packets
    std::vector<std::string> stopped; ///< processes that had not ended when their processor halted
    std::optional<Time> held_since;   ///< for the fault `hogged`: time from which an added master kept the bus
    std::uint64_t bus_errors = 0;     ///< for the fault `absent`: number of accesses that the device did not answer

    bool had_effect() const {
        return first || held_since || bus_errors > 0 || !stopped.empty() || !stopped_channels.empty();
    }
};

/// Reports the work of a switch that a program sets.
struct SwitchUse {
    std::string name;
    std::uint64_t commands = 0, connections = 0; ///< `commands` obeyed; `connections` of an output made
    /// Counts the bytes and acknowledges that the switch lost on the way from one link to another.
    struct Loss {
        std::string from, to; ///< the links
        std::uint64_t bytes = 0, acknowledges = 0;
        FaultUse::Hit first;
        int output;        ///< number of the switch's output at which the first byte or acknowledge was lost
        std::string state; ///< state of this output at that time: "was connected to no input"
    };
    std::vector<Loss> losses;
};

/// Holds a table about a device for which this file has no structure, such as a device that a user's program adds.
struct DeviceUse {
    std::string title;                ///< "ring r"
    Time busy;                        ///< time for which the device carried messages
    std::vector<std::string> columns; ///< headings of the columns; the first heading is for the names of the rows
    struct Row {
        std::string name;
        std::vector<std::variant<std::uint64_t, Time>> figures; ///< one for each column except the first
    };
    std::vector<Row> rows;
};

/// Reports on an emulated transputer, which executes machine code.
struct ProgramUse {
    std::string name; ///< name of the transputer
    std::uint64_t instructions = 0;
    std::uint64_t requests = 0; ///< requests to its host
    std::string state;          ///< "exited with success", "was never booted"
    std::string listing = "";   ///< the executed instructions with their counts, as text; "" if they were not counted
    std::string analysis = "";  ///< the state of the transputer at the end, as text; "" if the user did not ask for it
    bool failed = false; ///< the program exited with failure or sent bytes that are not a request, or the transputer
                         ///< stopped
    bool halted = false; ///< an error of the program has halted the transputer
    Time booted_at{};    ///< time at which the host had sent the whole bootable file
    /// Describes a process that an error stopped, while the transputer's other processes continued.
    struct Stop {
        std::string process;
        std::string place; ///< place in the source, such as "ring.occ:12:3"
        std::string error; ///< "division by zero: 1 / 0"
        Time at;
    };
    std::vector<Stop> stops{};        ///< the first of the processes that errors stopped
    std::uint64_t count_of_stops = 0; ///< number of all processes that errors stopped
};

/// Reports how a run used its machine. Each simulated device adds its part (MachineNode::report).
struct MachineUse {
    std::vector<ProcessorUse> processors;
    std::vector<LinkUse> links;
    std::vector<BusUse> buses;
    std::vector<SwitchUse> switches; ///< switches that programs set
    std::vector<DeviceUse> devices;
    std::vector<ProgramUse> programs; ///< transputers that execute their own code
};

} // namespace placedpar
