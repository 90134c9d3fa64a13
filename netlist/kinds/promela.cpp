#include "netlist/kinds/promela.hpp"

#include "netlist/network/names.hpp"
#include "netlist/network/network.hpp"

#include <fmt/format.h>

#include <variant>

namespace placedpar {

namespace {

std::string name_of_channel(std::size_t number) { return fmt::format("c[{}]", number); }

} // namespace

std::int64_t PromelaProcess::integer(std::string_view parameter) const {
    return std::get<std::int64_t>(network_.processes[process_].parameters.at(std::string(parameter)));
}

std::string PromelaProcess::channel(std::string_view port) const { return channels(port).at(0); }

std::vector<std::string> PromelaProcess::channels(std::string_view port) const {
    std::vector<std::string> names;
    for (std::size_t number : numbers(port))
        names.push_back(name_of_channel(number));
    return names;
}

std::string PromelaProcess::channel_if(std::string_view condition, const std::string& channel) const {
    std::string number = channel.substr(2, channel.size() - 3);
    return fmt::format("c[(({}) -> {} : {})]", condition, number, network_.channels.size());
}

std::vector<std::size_t> PromelaProcess::numbers(std::string_view port) const {
    std::vector<std::size_t> numbers;
    for (const PortBinding& binding : network_.processes[process_].ports)
        if (base_name(binding.port) == port && binding.channel != nowhere)
            numbers.push_back(binding.channel);
    return numbers;
}

std::string promela_loop(std::int64_t times, const std::string& statements) {
    return fmt::format("for (i : 1 .. {}) {{\n{}}}\n", times, statements);
}

} // namespace placedpar
