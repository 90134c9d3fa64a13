#pragma once

#include "netlist/kinds/parameter.hpp"
#include "netlist/kinds/promela.hpp"
#include "netlist/network/direction.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

namespace placedpar {

class AnyChannel;         // runtime/channel.hpp: a channel of some protocol
class ProcessEnvironment; // netlist/kinds/environment.hpp: what a running process sees of its netlist
struct Network;           // netlist/network/network.hpp: a whole netlist, elaborated

/// One channel end in the interface of a process kind; description.hpp makes them.
struct PortDescription {
    std::string name;
    Direction direction;
    bool optional;        ///< may stay unconnected; a port that is not optional must be connected
    std::string protocol; ///< the protocol's name, for people
    std::type_index type; ///< the C++ type that the channel carries; both ends must agree
    std::function<std::unique_ptr<AnyChannel>(std::string name)> make_channel;
    std::string about;         ///< one line
    std::string formerly = ""; ///< the name that older netlists know it by; "" where it has always had this one
};

/// One quantity that a process of this kind measures itself and reports at the end of a run.
struct MeasurementDescription {
    std::string name;
    std::string unit;
    std::string about;
};

/// What is wrong, or hardly meant, with a process beyond what ranges and single ports can say.
struct Complaint {
    std::size_t process = 0; ///< the process at fault; not always the one whose kind was asked
    std::string about;       ///< the parameter or the port at fault, whose place is shown; "": the process
    std::string message, hint;
    bool warning = false; ///< said, but the netlist is good
};

/// A kind of process that a netlist can name in `use "kind" for process;`.
struct ProcessKind {
    std::string name;  ///< such as "ga.master"
    std::string about; ///< a short paragraph
    std::vector<PortDescription> ports = {};
    std::vector<ParameterDescription> parameters = {};
    std::vector<MeasurementDescription> measurements = {};
    std::function<void(ProcessEnvironment&)> body = {};
    /// Groups of ports of which a netlist connects all or none.
    std::vector<std::vector<std::string>> together = {};
    /// May be empty. Called for each process of the kind, with a network in which everything else is right.
    std::function<std::vector<Complaint>(const Network&, std::size_t process)> check = {};
    /// Whether what a process of the kind does and sends follows from its messages, its parameters, its random streams,
    /// the choices of its ALTs and the readings of its clock, and from nothing else, such as what components of its
    /// PARs share. Then runs with other seeds need not be simulated on the machine (repeated_run.hpp). Empty: no.
    std::function<bool(const Network&, std::size_t process)> is_determinate = {};
    /// What a process of the kind communicates, for Spin. May be empty: such networks have no model.
    PromelaStatements promela = {};
    /// Whether a program that is built on PlacedPar adds it: what its processes throw, or it where it is asked, is
    /// then that program's, not a defect of PlacedPar.
    bool is_own = false;

    /// Null where there is none.
    const PortDescription* port(std::string_view name) const;
    const ParameterDescription* parameter(std::string_view name) const;
    /// For someone who names a port that it does not have: what that port is called now, or the nearest name; "" where
    /// none is near.
    std::string hint_at_port(std::string_view wanted) const;
};

/// For ProcessKind::is_determinate.
inline bool always(const Network&, std::size_t) { return true; }

} // namespace placedpar
