#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Gives a kind of process what it needs to print one of its processes in Promela, the language of the model checker
/// Spin (G. Holzmann, "The Spin Model Checker", 2003): the parameters of the process, and the names of its channels. In
/// Promela, the channels are elements of the array `c` of rendezvous channels.
class PromelaProcess {
public:
    PromelaProcess(const Network& network, std::size_t process) : network_(network), process_(process) {}

    std::int64_t integer(std::string_view parameter) const;
    bool connected(std::string_view port) const { return !numbers(port).empty(); }
    /// Returns the port's channel, such as "c[3]". REQUIRES: the port is connected, and not an array.
    std::string channel(std::string_view port) const;
    /// Returns the channels of a port array, in order.
    std::vector<std::string> channels(std::string_view port) const;
    /// Returns a Promela expression for a channel with a guard, as in an ALT of occam: the channel if the condition
    /// holds, otherwise a channel on which no message ever passes.
    std::string channel_if(std::string_view condition, const std::string& channel) const;

private:
    std::vector<std::size_t> numbers(std::string_view port) const;

    const Network& network_;
    std::size_t process_;
};

/// Returns the Promela statements of a process: its communications in order, without computations and times. The
/// statements may use the variables `i`, an int, and `m`, a byte that represents any message. Each statement is on a
/// separate line, without indentation.
using PromelaStatements = std::function<std::string(const PromelaProcess&)>;

/// Returns a loop in Promela: "for (i : 1 .. 10) {", the statements, "}".
std::string promela_loop(std::int64_t times, const std::string& statements);

} // namespace placedpar
