#include "runtime/hardware/crossbar.hpp"

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

std::size_t SwitchCommand::bytes() const {
    switch (kind) {
    case Kind::connect_output:
    case Kind::connect_links:
    case Kind::disconnect_links: return 3;
    case Kind::enquire:
    case Kind::disconnect_output: return 2;
    case Kind::ready:
    case Kind::reset: return 1;
    }
    return 1;
}

namespace {

void require_links(const SwitchCommand& command, const std::string& crossbar) {
    for (std::size_t i = 1; i < command.bytes(); ++i)
        if (int link = i == 1 ? command.first : command.second; link >= Crossbar::links)
            throw std::invalid_argument(fmt::format("the switch {} has no link {}: its links are 0 to {}", crossbar,
                                                    link, Crossbar::links - 1));
}

} // namespace

Crossbar::Crossbar(Kernel& kernel, std::string name) : Executive(std::move(name), OperationCosts{}), kernel_(kernel) {}

Crossbar& Crossbar::here() {
    const Process& self = Kernel::here().running();
    if (auto* crossbar = dynamic_cast<Crossbar*>(self.executive()))
        return *crossbar;
    throw std::logic_error("process " + self.path() + " is not on a crossbar switch");
}

std::optional<SwitchAnswer> Crossbar::obey(const SwitchCommand& command) {
    using Kind = SwitchCommand::Kind;
    require_links(command, name());
    ++commands_;
    switch (command.kind) {
    case Kind::connect_output: return connect(command.first, command.second), std::nullopt;
    case Kind::connect_links:
        connect(command.first, command.second);
        return connect(command.second, command.first), std::nullopt;
    case Kind::enquire: return answer(command.first);
    case Kind::ready: return make_all_ready(), std::nullopt;
    case Kind::reset:
        for (int output = 0; output < links; ++output)
            disconnect(output);
        return std::nullopt;
    case Kind::disconnect_output: return disconnect(command.first), std::nullopt;
    case Kind::disconnect_links: disconnect(command.first); return disconnect(command.second), std::nullopt;
    }
    throw std::invalid_argument(fmt::format("the switch {} has no command {}", name(), static_cast<int>(command.kind)));
}

bool Crossbar::leads(int input, int output) const {
    const Choice& choice = choices_[static_cast<std::size_t>(output)];
    return choice.ready && choice.input == input;
}

void Crossbar::lead_on(Link& link, int at_a, int at_b) {
    link.lead_through(ways_.emplace_back(*this, link, at_a, at_b));
}

void Crossbar::connect(int input, int output) {
    if (choices_[static_cast<std::size_t>(output)].input == input)
        return;
    ++connections_;
    change(output, {input, false});
}

void Crossbar::disconnect(int output) {
    if (choices_[static_cast<std::size_t>(output)].input != nothing)
        change(output, {});
}

void Crossbar::make_all_ready() {
    for (int output = 0; output < links; ++output)
        if (const Choice& choice = choices_[static_cast<std::size_t>(output)]; choice.input != nothing && !choice.ready)
            change(output, {choice.input, true});
}

void Crossbar::change(int output, const Choice& choice) {
    std::deque<Link::WayChange> changes;
    for (SwitchedLink& way : ways_)
        if (way.at_a == output || way.at_b == output)
            changes.emplace_back(way.link);
    Choice before = std::exchange(choices_[static_cast<std::size_t>(output)], choice);
    if (kernel_.trace())
        trace_change(output, before);
}

SwitchAnswer Crossbar::answer(int output) const {
    const Choice& choice = choices_[static_cast<std::size_t>(output)];
    return {choice.input == nothing ? std::uint8_t{0}
                                    : static_cast<std::uint8_t>(choice.input | SwitchAnswer::connected)};
}

std::string Crossbar::state_of(int output) const {
    const Choice& choice = choices_[static_cast<std::size_t>(output)];
    if (choice.input == nothing)
        return "was connected to no input";
    return fmt::format("was connected to input {}{}", choice.input,
                       choice.ready ? "" : ", but had not received command 3");
}

/// Shows a change of a connection in the trace. Each output has a row of the trace, which names the input to which it
/// is connected.
void Crossbar::trace_change(int output, const Choice& before) const {
    const Choice& choice = choices_[static_cast<std::size_t>(output)];
    std::string track = fmt::format("{}.link[{}]", name(), output);
    Time now = kernel_.now();
    if (before.ready)
        kernel_.trace()->leaves({track, now}, now);
    if (choice.ready)
        kernel_.trace()->takes({track, fmt::format("from link[{}]", choice.input), now}, now);
}

bool Crossbar::SwitchedLink::leads_on(bool leaves_a) const {
    return leaves_a ? crossbar.leads(at_a, at_b) : crossbar.leads(at_b, at_a);
}

void Crossbar::SwitchedLink::lose(const FaultEffect::Hit& packet, bool leaves_a) {
    Loss& loss = leaves_a ? from_a : from_b;
    if (!loss.effect.first) {
        loss.effect.first = packet;
        loss.output = output(leaves_a);
        loss.state = crossbar.state_of(loss.output);
    }
    loss.effect.last = packet;
    ++(packet.acknowledge ? loss.effect.acknowledges_lost : loss.effect.bytes_lost);
}

std::deque<Crossbar::Loss> Crossbar::losses() const {
    std::deque<Loss> losses;
    for (const SwitchedLink& way : ways_)
        for (const Loss* loss : {&way.from_a, &way.from_b})
            if (loss->effect.first)
                losses.push_back(*loss);
    return losses;
}

bool Crossbar::begin_computing(Process&, Cycles, const CodeShape&) { return true; }

void Crossbar::make_ready(Process& process) { kernel_.enqueue(process); }

void Crossbar::leave(Process&, Process* successor) {
    if (successor)
        make_ready(*successor);
}

} // namespace placedpar::hardware
