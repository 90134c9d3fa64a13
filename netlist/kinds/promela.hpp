#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// A process as its kind describes it in Promela, the language of the model checker Spin (G. Holzmann, "The Spin Model
/// Checker", 2003): its parameters, and its channels as places of the array `c` of rendezvous channels.
class PromelaProcess {
public:
    PromelaProcess(const Network& network, std::size_t process) : network_(network), process_(process) {}

    std::int64_t integer(std::string_view parameter) const;
    bool connected(std::string_view port) const { return !numbers(port).empty(); }
    /// Such as "c[3]". REQUIRES: it is connected, and no array.
    std::string channel(std::string_view port) const;
    /// Of an array, in order.
    std::vector<std::string> channels(std::string_view port) const;
    /// The channel while the condition holds, else one on which nothing ever passes: an occam guard.
    std::string channel_if(std::string_view condition, const std::string& channel) const;

private:
    std::vector<std::size_t> numbers(std::string_view port) const;

    const Network& network_;
    std::size_t process_;
};

/// The statements of a process: what it communicates, in which order, without what it computes and how long that
/// takes. They may use the variables `i`, an int, and `m`, a byte that stands for any message. A line each, without
/// indentation.
using PromelaStatements = std::function<std::string(const PromelaProcess&)>;

/// "for (i : 1 .. 10) {", the statements, "}".
std::string promela_loop(std::int64_t times, const std::string& statements);

} // namespace placedpar
