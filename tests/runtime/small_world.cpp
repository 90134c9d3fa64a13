#include "small_world.hpp"

#include <fmt/format.h>

namespace placedpar::test {

std::string SmallWorld::text() const {
    std::string out;
    for (const Ends& ends : channels)
        out += fmt::format("{}>{} ", ends.outputter, ends.inputter);
    for (const auto& actions : processes) {
        out += "|";
        for (const Action& action : actions)
            out += action.kind == Action::alternate ? " A"
                   : action.kind == Action::poll
                       ? " P"
                       : fmt::format(" {}{}", action.kind == Action::output ? '!' : '?', action.channel);
        out += " ";
    }
    return out;
}

const Action* Interpreter::next(const State& state, std::size_t process) const {
    const auto& actions = world_.processes[process];
    return state[process] < actions.size() ? &actions[state[process]] : nullptr;
}

bool Interpreter::offers_input(const State& state, std::size_t channel) const {
    const Action* action = next(state, world_.channels[channel].inputter);
    return action && action->kind != Action::output && (action->kind != Action::input || action->channel == channel);
}

bool Interpreter::can_communicate(const State& state, std::size_t channel) const {
    const Action* action = next(state, world_.channels[channel].outputter);
    return action && action->kind == Action::output && action->channel == channel && offers_input(state, channel);
}

Interpreter::States Interpreter::after_polls(States states) const {
    for (States newest = states; !newest.empty();) {
        States found;
        for (const State& state : newest)
            for (std::size_t process = 0; process < 3; ++process)
                if (const Action* action = next(state, process); action && action->kind == Action::poll) {
                    State skipped = state;
                    ++skipped[process];
                    if (states.insert(skipped).second)
                        found.insert(skipped);
                }
        newest = std::move(found);
    }
    return states;
}

Interpreter::States Interpreter::after(const States& states, std::size_t channel) const {
    States result;
    for (State state : states)
        if (can_communicate(state, channel)) {
            ++state[world_.channels[channel].outputter];
            ++state[world_.channels[channel].inputter];
            result.insert(state);
        }
    return after_polls(std::move(result));
}

bool Interpreter::can_end(const States& states, bool completed) const {
    for (const State& state : states) {
        bool all_over = true, stuck = true;
        for (std::size_t process = 0; process < 3; ++process) {
            const Action* action = next(state, process);
            all_over = all_over && !action;
            stuck = stuck && !(action && action->kind == Action::poll);
        }
        for (std::size_t channel = 0; channel < world_.channels.size(); ++channel)
            stuck = stuck && !can_communicate(state, channel);
        if (stuck && all_over == completed)
            return true;
    }
    return false;
}

Interpreter::States Interpreter::reachable() const {
    States found = start();
    std::vector<State> open(found.begin(), found.end());
    while (!open.empty()) {
        State state = open.back();
        open.pop_back();
        for (std::size_t channel = 0; channel < world_.channels.size(); ++channel)
            for (const State& next : after({state}, channel))
                if (found.insert(next).second)
                    open.push_back(next);
    }
    return found;
}

std::set<std::string> Interpreter::traces() const {
    std::set<std::string> found;
    follow(start(), "", found);
    return found;
}

void Interpreter::follow(const States& states, const std::string& trace, std::set<std::string>& found) const {
    if (can_end(states, true) || can_end(states, false))
        found.insert(trace);
    for (std::size_t channel = 0; channel < world_.channels.size(); ++channel)
        if (States next_states = after(states, channel); !next_states.empty())
            follow(next_states, trace + static_cast<char>('0' + channel), found);
}

} // namespace placedpar::test
