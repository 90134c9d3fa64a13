#pragma once

#include "netlist/kinds/parameter.hpp"
#include "netlist/kinds/promela.hpp"
#include "netlist/network/direction.hpp"

#include <cstddef>
#include <cstdint>
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

/// Describes a channel end in the interface of a process kind. Functions of description.hpp make descriptions.
struct PortDescription {
    std::string name;
    Direction direction;
    bool optional;        ///< false if every netlist must connect the port
    std::string protocol; ///< the protocol's name in messages and reports
    std::type_index type; ///< the C++ type that the channel carries; both ends must agree
    std::function<std::unique_ptr<AnyChannel>(std::string name)> make_channel;
    std::string about;          ///< one line
    std::string formerly = "";  ///< the port's name in older netlists; "" if the name has never changed
    bool has_byte_form = false; ///< a transputer's own code can send or receive the messages (HasByteForm)
    std::type_index bytes_as =
        type; ///< the C++ type with the same byte form as the messages: `type`, or ByteForm::SameAs
    /// Lists the C++ types that have the same byte form as the messages. Only ports of processes in occam have such a
    /// list (ProcessKind::is_code).
    std::vector<std::type_index> byte_types = {};
    std::int64_t elements = 0; ///< number of channels of the port; 0: the netlist decides
    bool to_host = false;      ///< a port that is not connected leads to the host; only for processes in occam
};

/// Describes a quantity that a process of this kind measures and reports at the end of a run.
struct MeasurementDescription {
    std::string name;
    std::string unit;
    std::string about;
};

/// Describes an error or a probable mistake in a process, found by the kind's own check.
struct Complaint {
    std::size_t process = 0; ///< the process at fault, which may differ from the checked process
    std::string about; ///< the parameter or port at fault, whose place is shown; "": the place of the process is shown
    std::string message, hint;
    bool warning = false; ///< the complaint is shown, but the netlist is accepted
};

/// Describes a kind of process, which a netlist can name in `use "kind" for process;`.
struct ProcessKind {
    std::string name;  ///< such as "ga.master"
    std::string about; ///< a short paragraph
    std::vector<PortDescription> ports = {};
    std::vector<ParameterDescription> parameters = {};
    std::vector<MeasurementDescription> measurements = {};
    std::function<void(ProcessEnvironment&)> body = {};
    /// Lists groups of ports; a netlist must connect all ports of a group, or none.
    std::vector<std::vector<std::string>> together = {};
    /// Checks one process of the kind, in a network that has passed all other checks. An empty function accepts every
    /// process.
    std::function<std::vector<Complaint>(const Network&, std::size_t process)> check = {};
    /// Returns whether the actions and outputs of a process of the kind depend only on its inputs, its parameters, its
    /// random streams, the choices of its ALTs and the readings of its clock. Variables that are shared by the
    /// components of its PARs, for example, are not allowed. Runs of such processes with other seeds need not be
    /// simulated on the machine (repeated_run.hpp). An empty function means no.
    std::function<bool(const Network&, std::size_t process)> is_determinate = {};
    /// Returns the Promela statements of a process of the kind. If the function is empty, networks with such processes
    /// cannot be printed for Spin.
    PromelaStatements promela = {};
    /// True if a program built on PlacedPar adds this kind. An exception from the kind or from its processes is then an
    /// error of that program, not a defect of PlacedPar.
    bool is_own = false;
    /// True if the kind is made from a source file in occam (FileKinds). The emulated transputer then executes the
    /// compiled code of its processes, and the kind has no body.
    bool is_code = false;
    std::uint64_t text_hash = 0; ///< hash of the source files from which the kind is made; 0 for other kinds

    /// Returns null if there is no port of this name.
    const PortDescription* port(std::string_view name) const;
    const ParameterDescription* parameter(std::string_view name) const;
    /// Returns a hint for a wrong port name. If the port was renamed, the hint has its present name, otherwise the
    /// nearest name; "" if no name is near.
    std::string hint_at_port(std::string_view wanted) const;
};

/// Serves as ProcessKind::is_determinate if every process of the kind is determinate.
inline bool always(const Network&, std::size_t) { return true; }

} // namespace placedpar
