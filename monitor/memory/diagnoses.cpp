#include "monitor/memory/diagnoses.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace placedpar::monitor {

using namespace identification;

Diagnosis& Diagnoses::greet(const Hello& hello) {
    return hello.role == Role::watch ? watched_by(hello) : controlled_by(hello);
}

Diagnosis& Diagnoses::watched_by(const Hello& hello) {
    auto found = diagnoses_.find(hello.machine);
    if (found == diagnoses_.end())
        throw BadMessage("machine", fmt::format("unknown machine \"{}\"", hello.machine),
                         "a machine whose control system has sent hello");
    return found->second;
}

Diagnosis& Diagnoses::controlled_by(const Hello& hello) {
    auto found = diagnoses_.find(hello.machine);
    bool known = found != diagnoses_.end();
    if (known && !hello.anew && found->second.parameters() != hello.parameters)
        throw BadMessage("machine", fmt::format("\"{}\" is already known with other parameters", hello.machine),
                         "the same parameters, or \"anew\":true to forget the machine's state");
    if (known && hello.anew)
        diagnoses_.erase(found);
    else if (!known && diagnoses_.size() >= most_)
        throw BadMessage("machine", fmt::format("the monitor has as many machines as it may: {}", diagnoses_.size()),
                         "one of the known machines; --max-machines allows more");
    auto [place, made] = diagnoses_.try_emplace(hello.machine, hello.machine, hello.parameters, settings_, seed_);
    place->second.connected();
    return place->second;
}

void Diagnoses::add(Diagnosis::State state) {
    std::string name = state.name;
    diagnoses_.try_emplace(name, std::move(state), settings_, seed_);
}

void Diagnoses::replay(const std::string& machine, std::string_view text) {
    Message message = parse_message(text);
    auto found = diagnoses_.find(machine);
    if (found == diagnoses_.end())
        throw BadMessage("machine", fmt::format("unknown machine \"{}\"", machine),
                         "hello before any other message about the machine");
    if (const auto* change = std::get_if<ConfigurationChange>(&message))
        found->second.change(*change);
    else if (const auto* recognised = std::get_if<RecognisedConfiguration>(&message))
        found->second.change(*recognised);
    else if (const auto* sample = std::get_if<ExcavatorSample>(&message))
        found->second.take(*sample);
    else if (const auto* baseline = std::get_if<Baseline>(&message))
        found->second.set_baseline(*baseline);
}

} // namespace placedpar::monitor
