#include "monitor/memory/machines.hpp"

#include <fmt/format.h>

namespace placedpar::monitor {

using namespace hydraulics;

Machine& Machines::greet(const Hello& hello) {
    auto found = machines_.find(hello.machine);
    if (hello.role == Role::watch) {
        if (found == machines_.end())
            throw BadMessage("machine", fmt::format("there is no machine \"{}\"", hello.machine),
                             "a machine whose control system has said hello");
        return found->second;
    }
    bool known = found != machines_.end();
    if (known && !hello.anew && found->second.parameters() != hello.parameters)
        throw BadMessage("machine", fmt::format("\"{}\" is known with other parameters", hello.machine),
                         "the same, or \"anew\":true to forget what is known of it");
    if (known && hello.anew)
        machines_.erase(found);
    else if (!known && machines_.size() >= most_)
        throw BadMessage("machine", fmt::format("there are {} machines already", machines_.size()),
                         "one of those; --max-machines allows more");
    auto [place, made] = machines_.try_emplace(hello.machine, hello.machine, hello.parameters, settings_, seed_);
    place->second.connected();
    return place->second;
}

void Machines::add(Machine::State state) {
    std::string name = state.name;
    machines_.try_emplace(name, std::move(state), settings_, seed_);
}

void Machines::replay(const std::string& machine, std::string_view text) {
    Message message = parse_message(text);
    if (const auto* hello = std::get_if<Hello>(&message)) {
        greet(*hello);
        return;
    }
    auto found = machines_.find(machine);
    if (found == machines_.end())
        throw BadMessage("machine", fmt::format("there is no machine \"{}\"", machine), "a hello before");
    if (const auto* change = std::get_if<ConfigurationChange>(&message))
        found->second.change(*change);
    else if (const auto* sample = std::get_if<SampleMessage>(&message))
        found->second.take(*sample);
    else if (const auto* baseline = std::get_if<BaselineMessage>(&message))
        found->second.set_baseline(*baseline);
}

} // namespace placedpar::monitor
