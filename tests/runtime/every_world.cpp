#include "tests/runtime/every_world.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace placedpar::test {

namespace {

constexpr std::size_t processes = 3;

/// An order of the processes, for naming them anew.
using Order = std::array<std::size_t, processes>;

/// Describes a world independently of the names of its channels. The least description over all orders of the processes
/// identifies the world.
class Description {
public:
    Description(const SmallWorld& world, const Order& order)
        : world_(world), order_(order), names_(world.channels.size()) {
        for (std::size_t i = 0; i < processes; ++i)
            name_of_[order[i]] = static_cast<char>('0' + i);
        name_channels();
    }

    std::string text() const {
        std::string out;
        for (std::size_t process : order_) {
            for (const Action& action : world_.processes[process])
                out += text(action);
            out += '|';
        }
        return out;
    }

private:
    /// Names the channels of each pair of processes in the order of their first use.
    void name_channels() {
        std::array<std::array<char, processes>, processes> next{};
        for (std::size_t process : order_)
            for (const Action& action : world_.processes[process])
                if (!action.is_alternation() && names_[action.channel].empty()) {
                    auto [outputter, inputter] = world_.channels[action.channel];
                    char number = ++next[outputter][inputter];
                    names_[action.channel] = {name_of_[outputter], name_of_[inputter], number};
                }
    }
    std::string text(const Action& action) const {
        std::string out(1, "!?AP"[action.kind]);
        return action.is_alternation() ? out + guards(action) : out + names_[action.channel];
    }
    std::string guards(const Action& alternation) const {
        std::vector<std::string> on;
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (alternation.is_guarded_by(i))
                on.push_back(names_[i]);
        std::ranges::sort(on);
        std::string out;
        for (const std::string& name : on)
            out += name;
        return out;
    }

    const SmallWorld& world_;
    Order order_;
    std::array<char, processes> name_of_{};
    std::vector<std::string> names_;
};

/// Calls `is_it` with the description for each order of the processes, beginning with the given order, until `is_it`
/// returns true.
bool any_description(const SmallWorld& world, const std::function<bool(const std::string&)>& is_it) {
    Order order{0, 1, 2};
    do
        if (is_it(Description(world, order).text()))
            return true;
    while (std::ranges::next_permutation(order).found);
    return false;
}

bool is_first_of_its_kind(const SmallWorld& world) {
    const std::string as_it_is = Description(world, {0, 1, 2}).text();
    return !any_description(world, [&](const std::string& other) { return other < as_it_is; });
}

/// Generates worlds by adding an action where an execution reaches the end of a process. The first use of a channel
/// creates the channel. The next place to grow does not depend on the names of channels, so each world is generated in
/// only one way.
class Worlds {
public:
    Worlds(const Bounds& bounds, const std::function<void(const SmallWorld&)>& check)
        : bounds_(bounds), check_(check) {}

    void grow() {
        std::optional<std::size_t> process = asked_for_more();
        if (!process)
            return hand_over();
        use_channels(*process);
        lay_channels(*process);
        alternate(*process, Action::alternate);
        if (bounds_.polls)
            alternate(*process, Action::poll);
        ended_[*process] = true;
        grow();
        ended_[*process] = false;
    }

private:
    bool may_grow(std::size_t process) const {
        std::size_t in_all = 0;
        for (const auto& actions : world_.processes)
            in_all += actions.size();
        return !ended_[process] && world_.processes[process].size() < bounds_.longest && in_all < bounds_.most_in_all;
    }
    /// Returns the first process that may grow and whose last action some execution passes.
    std::optional<std::size_t> asked_for_more() const {
        const auto states = Interpreter(world_).reachable();
        for (std::size_t process = 0; process < processes; ++process)
            if (may_grow(process) && std::ranges::any_of(states, [&](const Interpreter::State& state) {
                    return state[process] == world_.processes[process].size();
                }))
                return process;
        return std::nullopt;
    }

    void hand_over() const {
        for (const auto& actions : world_.processes)
            for (const Action& action : actions)
                if (action.is_alternation() && action.guards == 0)
                    return;
        if (is_first_of_its_kind(world_))
            check_(world_);
    }

    void grow_by(std::size_t process, const Action& action) {
        world_.processes[process].push_back(action);
        grow();
        world_.processes[process].pop_back();
    }

    void use_channels(std::size_t process) {
        for (std::size_t i = 0; i < world_.channels.size(); ++i) {
            if (world_.channels[i].outputter == process)
                grow_by(process, {Action::output, i});
            if (world_.channels[i].inputter == process)
                grow_by(process, {Action::input, i});
        }
    }

    void lay_channels(std::size_t process) {
        for (std::size_t other = 0; other < processes; ++other)
            if (other != process) {
                lay_channel(process, Action::output, {process, other});
                lay_channel(process, Action::input, {other, process});
            }
    }
    void lay_channel(std::size_t process, Action::Kind kind, const SmallWorld::Ends& ends) {
        const std::size_t channel = world_.channels.size();
        const std::uint32_t bit = std::uint32_t{1} << channel;
        world_.channels.push_back(ends);
        for_each_choice(alternations(ends.inputter), [&](std::uint32_t chosen) {
            set_guards(ends.inputter, bit, chosen);
            grow_by(process, {kind, channel});
        });
        set_guards(ends.inputter, bit, 0);
        world_.channels.pop_back();
    }
    /// Returns a bit for each action of the process; it is 1 if the action is an alternation.
    std::uint32_t alternations(std::size_t process) const {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < world_.processes[process].size(); ++i)
            if (world_.processes[process][i].is_alternation())
                bits |= std::uint32_t{1} << i;
        return bits;
    }
    void set_guards(std::size_t process, std::uint32_t channel_bit, std::uint32_t chosen) {
        for (std::size_t i = 0; i < world_.processes[process].size(); ++i) {
            std::uint32_t& guards = world_.processes[process][i].guards;
            guards = (guards & ~channel_bit) | ((chosen >> i & 1) != 0 ? channel_bit : 0);
        }
    }

    void alternate(std::size_t process, Action::Kind kind) {
        std::uint32_t inputs = 0;
        for (std::size_t i = 0; i < world_.channels.size(); ++i)
            if (world_.channels[i].inputter == process)
                inputs |= std::uint32_t{1} << i;
        for_each_choice(inputs, [&](std::uint32_t chosen) { grow_by(process, {kind, 0, chosen}); });
    }
    /// Calls `choice` with all bits set. If any guards are allowed, calls it with every subset of them.
    template <class Choice>
    void for_each_choice(std::uint32_t bits, Choice choice) {
        choice(bits);
        for (std::uint32_t rest = bits; bounds_.any_guards && rest != 0;) {
            rest = (rest - 1) & bits;
            choice(rest);
        }
    }

    const Bounds& bounds_;
    const std::function<void(const SmallWorld&)>& check_;
    SmallWorld world_;
    std::array<bool, processes> ended_{};
};

} // namespace

std::string text_of_its_kind(const SmallWorld& world) {
    std::string first = Description(world, {0, 1, 2}).text();
    any_description(world, [&](const std::string& other) {
        first = std::min(first, other);
        return false;
    });
    return first;
}

void for_every_world(const Bounds& bounds, const std::function<void(const SmallWorld&)>& check) {
    Worlds(bounds, check).grow();
}

} // namespace placedpar::test
