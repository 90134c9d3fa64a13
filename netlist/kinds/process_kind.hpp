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

/// Describes a port: a channel end, or an array of channel ends, in the interface of a kind of process. Functions of
/// description.hpp make descriptions.
struct PortDescription {
    std::string name;
    Direction direction;
    bool optional;        ///< true if a netlist may leave the port unconnected
    std::string protocol; ///< the protocol's name in messages and reports
    std::type_index type; ///< C++ type of the messages; two processes in C++ must use the same type
    std::function<std::unique_ptr<AnyChannel>(std::string name)> make_channel;
    std::string about;          ///< one line
    std::string formerly = "";  ///< name of the port in older netlists; "" if the name has never changed
    bool has_byte_form = false; ///< the messages have a form in bytes (HasByteForm), in which a transputer's machine
                                ///< code can send or receive them
    std::type_index bytes_as = type; ///< C++ type whose messages have the same bytes: `type`, or ByteForm::SameAs
    /// For a port of a process in occam: lists the C++ types whose messages have the same bytes as the messages of the
    /// occam protocol. Empty for other ports.
    std::vector<std::type_index> byte_types = {};
    std::int64_t elements = 0; ///< number of channels of a port array; 0: the netlist states the number
    bool to_host = false; ///< for a process in occam: if the netlist leaves the port unconnected, it leads to the host
};

/// Describes a quantity that a process of this kind measures and reports at the end of a run.
struct MeasurementDescription {
    std::string name;
    std::string unit;
    std::string about;
};

/// Describes an error or a probable mistake in a netlist that ProcessKind::check has found.
struct Complaint {
    std::size_t process = 0; ///< the process at fault, which may differ from the checked process
    std::string about; ///< parameter or port whose place in the netlist is shown; "": the place of the process is shown
    std::string message, hint;
    bool warning = false; ///< the complaint is shown, but the netlist is accepted
};

/// Describes a kind of process, which a netlist can name in a statement such as `use "csp.producer" for p;`. The
/// description has the function that processes of the kind execute, and what is needed to check netlists and to print
/// help.
struct ProcessKind {
    std::string name;  ///< such as "ga.master"
    std::string about; ///< a short paragraph
    std::vector<PortDescription> ports = {};
    std::vector<ParameterDescription> parameters = {};
    std::vector<MeasurementDescription> measurements = {};
    std::function<void(ProcessEnvironment&)> body = {};
    /// Lists groups of ports. Of each group, a netlist must connect all ports or none.
    std::vector<std::vector<std::string>> together = {};
    /// Checks one process of the kind, in a network that has passed all other checks. If the function is empty, every
    /// process is accepted.
    std::function<std::vector<Complaint>(const Network&, std::size_t process)> check = {};
    /// Returns whether a process of the kind is determinate: its actions and outputs depend only on its inputs, its
    /// parameters, its random numbers, the choices of its ALTs and the readings of its clock. For example, the
    /// components of its PARs must not share variables. If all processes are determinate, a run with another seed is
    /// possible without simulating the machine (repeated_run.hpp). If the function is empty, no process of the kind is
    /// determinate.
    std::function<bool(const Network&, std::size_t process)> is_determinate = {};
    /// Returns the statements of a process of the kind in Promela, the language of the model checker Spin. If the
    /// function is empty, networks with such processes cannot be printed for Spin.
    PromelaStatements promela = {};
    /// True if this kind is part of a user's program that is built on PlacedPar. An exception from the kind or from its
    /// processes is then an error of that program, not a defect of PlacedPar.
    bool is_own = false;
    /// True if the kind is made from a source file in occam (FileKinds). An emulated transputer then executes the
    /// compiled code of its processes, and `body` is empty.
    bool is_code = false;
    std::uint64_t text_hash = 0; ///< hash of the source files from which the kind is made; 0 for other kinds

    /// Return the port or parameter of this name; null if there is none.
    const PortDescription* port(std::string_view name) const;
    const ParameterDescription* parameter(std::string_view name) const;
    /// Returns a hint for a port name that does not exist. If it is the former name of a port, the hint has the present
    /// name; otherwise the hint has the most similar name. Returns "" if no name is similar.
    std::string hint_at_port(std::string_view wanted) const;
};

/// Is the value of ProcessKind::is_determinate for a kind of which every process is determinate.
inline bool always(const Network&, std::size_t) { return true; }

} // namespace placedpar
