#include "small_world.hpp"

#include <fmt/format.h>

#include <bitset>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace placedpar::test {

namespace {

std::string text_of(const Action& action, std::size_t channels) {
    if (!action.is_alternation())
        return fmt::format(" {}{}", action.kind == Action::output ? '!' : '?', action.channel);
    std::string out = action.kind == Action::poll ? " P" : " A";
    for (std::size_t i = 0; i < channels; ++i)
        if (action.is_guarded_by(i))
            out += std::to_string(i);
    return out;
}

} // namespace

namespace {

[[noreturn]] void refuse(const std::string& word) { throw std::invalid_argument("no word of a small world: " + word); }

std::size_t digit_of(const std::string& word, std::size_t at) {
    if (at >= word.size() || std::isdigit(static_cast<unsigned char>(word[at])) == 0)
        refuse(word);
    return static_cast<std::size_t>(word[at] - '0');
}

Action action_of(const std::string& word) {
    auto kind = std::string("!?AP").find(word[0]);
    if (kind == std::string::npos || word.size() < 2)
        refuse(word);
    Action action{static_cast<Action::Kind>(kind)};
    if (!action.is_alternation())
        action.channel = digit_of(word, 1);
    else
        for (std::size_t at = 1; at < word.size(); ++at)
            action.guards |= std::uint32_t{1} << digit_of(word, at);
    return action;
}

} // namespace

SmallWorld SmallWorld::of(const std::string& text) {
    SmallWorld world;
    std::istringstream words(text);
    std::size_t bars = 0;
    for (std::string word; words >> word;)
        if (word == "|")
            ++bars;
        else if (bars == 0)
            world.channels.push_back({digit_of(word, 0), digit_of(word, 2)});
        else
            world.processes.at(bars - 1).push_back(action_of(word));
    return world;
}

std::string SmallWorld::text() const {
    std::string out;
    for (const Ends& ends : channels)
        out += fmt::format("{}>{} ", ends.outputter, ends.inputter);
    for (const auto& actions : processes) {
        out += "|";
        for (const Action& action : actions)
            out += text_of(action, channels.size());
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
    return action && action->takes(channel);
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
    for (const State& state : states)
        if (can_communicate(state, channel))
            result.insert(communicated(state, channel));
    return after_polls(std::move(result));
}

Interpreter::State Interpreter::communicated(State state, std::size_t channel) const {
    ++state[world_.channels[channel].outputter];
    ++state[world_.channels[channel].inputter];
    return state;
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

bool Interpreter::allows(const std::string& trace, bool completed) const {
    States states = start();
    for (const char channel : trace)
        states = after(states, static_cast<std::size_t>(channel - '0'));
    return !states.empty() && can_end(states, completed);
}

std::vector<Interpreter::State> Interpreter::next_states(const State& state) const {
    std::vector<State> found;
    for (std::size_t channel = 0; channel < world_.channels.size(); ++channel)
        if (can_communicate(state, channel))
            found.push_back(communicated(state, channel));
    for (std::size_t process = 0; process < state.size(); ++process)
        if (const Action* action = next(state, process); action && action->kind == Action::poll) {
            found.push_back(state);
            ++found.back()[process];
        }
    return found;
}

std::vector<Interpreter::State> Interpreter::reachable() const {
    std::bitset<16 * 16 * 16> seen;
    std::vector<State> found{State{}};
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const State& next : next_states(State(found[i])))
            if (auto mark = seen[next[0] + 16u * next[1] + 256u * next[2]]; !mark) {
                mark = true;
                found.push_back(next);
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
