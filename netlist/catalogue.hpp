#pragma once

#include "netlist/value.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

namespace placedpar {

class AnyChannel;         // runtime/channel.hpp: a channel of some protocol
class ProcessEnvironment; // netlist/environment.hpp: what a running process sees of its netlist
struct Network;           // netlist/network.hpp: a whole netlist, elaborated

enum class Direction { input, output };

/// One channel end in the interface of a process kind.
struct PortDescription {
    std::string name;
    Direction direction;
    bool optional;        ///< may stay unconnected; a port that is not optional must be connected
    std::string protocol; ///< the protocol's name, for people
    std::type_index type; ///< the C++ type that the channel carries; both ends must agree
    std::function<std::unique_ptr<AnyChannel>(std::string name)> make_channel;
    std::string about; ///< one line
};

enum class ParameterType { integer, real, text };

/// One parameter in the interface of a process kind.
struct ParameterDescription {
    std::string name;
    ParameterType type;
    std::string unit;                   ///< "" where it has none
    std::optional<Value> default_value; ///< of the type stated; none: the netlist must give it
    std::optional<double> least, most;  ///< range, both ends allowed
    std::vector<std::string> choices;   ///< for text: the allowed words; empty: any text
    std::string about;                  ///< one line
};

/// One quantity that a process of this kind measures itself and reports at the end of a run.
struct MeasureDescription {
    std::string name;
    std::string unit;
    std::string about;
};

/// What is wrong with a process beyond what ranges and single ports can say.
struct Complaint {
    std::size_t process = 0; ///< whose; not always the one that was asked
    std::string about;       ///< the parameter or the port that it is about, whose place is shown; "": the process
    std::string message, hint;
};

/// A kind of process that a netlist can name in `use "kind" for process;`.
struct ProcessKind {
    std::string name;  ///< such as "ga.master"
    std::string about; ///< a short paragraph
    std::vector<PortDescription> ports;
    std::vector<ParameterDescription> parameters;
    std::vector<MeasureDescription> measures;
    std::function<void(ProcessEnvironment&)> body;
    /// Groups of ports of which a netlist connects all or none.
    std::vector<std::vector<std::string>> together = {};
    /// May be empty. Asked about each process of the kind, of a network in which everything else is right.
    std::function<std::vector<Complaint>(const Network&, std::size_t process)> check = {};

    const PortDescription* port(std::string_view name) const;
    const ParameterDescription* parameter(std::string_view name) const;
};

/// The process kinds that a program knows, by name. The rooms above add theirs to it; the checker of
/// netlists and `placedpar kinds` read it.
class Catalogue {
public:
    /// REQUIRES: no kind of that name yet; throws std::logic_error otherwise.
    void add(ProcessKind kind);
    /// Null where there is none.
    const ProcessKind* find(std::string_view name) const;
    const std::map<std::string, ProcessKind, std::less<>>& kinds() const { return kinds_; }

private:
    std::map<std::string, ProcessKind, std::less<>> kinds_;
};

} // namespace placedpar
