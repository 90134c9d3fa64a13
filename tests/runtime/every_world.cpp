#include "tests/runtime/every_world.hpp"

#include <algorithm>
#include <optional>

namespace placedpar::test {

namespace {

constexpr std::size_t processes = 3;
using Channels = std::vector<SmallWorld::Ends>;

std::vector<std::size_t> code(const Channels& channels) {
    std::vector<std::size_t> code;
    for (const SmallWorld::Ends& ends : channels)
        code.push_back(processes * ends.outputter + ends.inputter);
    std::sort(code.begin(), code.end());
    return code;
}

/// Whether no other names of the processes come before these.
bool first_of_its_kind(const Channels& channels) {
    std::vector<std::size_t> names{0, 1, 2};
    while (std::next_permutation(names.begin(), names.end())) {
        Channels renamed = channels;
        for (SmallWorld::Ends& ends : renamed)
            ends = {names[ends.outputter], names[ends.inputter]};
        if (code(renamed) < code(channels))
            return false;
    }
    return true;
}

void lay(Channels channels, std::size_t more, std::size_t from, std::vector<SmallWorld>& found) {
    if (more == 0) {
        if (first_of_its_kind(channels))
            found.push_back({channels, {}});
        return;
    }
    for (std::size_t next = from; next < processes * processes; ++next) {
        SmallWorld::Ends ends{next / processes, next % processes};
        if (ends.outputter == ends.inputter)
            continue;
        channels.push_back(ends);
        lay(channels, more - 1, next, found);
        channels.pop_back();
    }
}

/// Programs grow where a course comes to their end.
class Programs {
public:
    Programs(SmallWorld network, std::size_t longest, bool polls, const std::function<void(const SmallWorld&)>& check)
        : world_(std::move(network)), longest_(longest), check_(check) {
        for (std::size_t process = 0; process < processes; ++process)
            alphabets_[process] = alphabet(world_, process, polls);
    }

    void grow() {
        std::optional<std::size_t> process = asked_for_more();
        if (!process)
            return check_(world_);
        auto& actions = world_.processes[*process];
        for (const Action& action : alphabets_[*process]) {
            actions.push_back(action);
            grow();
            actions.pop_back();
        }
        ended_[*process] = true;
        grow();
        ended_[*process] = false;
    }

private:
    bool may_grow(std::size_t process) const { return !ended_[process] && world_.processes[process].size() < longest_; }
    /// The first process whose last action some course gets over, and that may have more.
    std::optional<std::size_t> asked_for_more() const {
        for (const Interpreter::State& state : Interpreter(world_).reachable())
            for (std::size_t process = 0; process < processes; ++process)
                if (may_grow(process) && state[process] == world_.processes[process].size())
                    return process;
        return std::nullopt;
    }

    SmallWorld world_;
    std::size_t longest_;
    const std::function<void(const SmallWorld&)>& check_;
    std::array<std::vector<Action>, processes> alphabets_;
    std::array<bool, processes> ended_{};
};

} // namespace

std::vector<Action> alphabet(const SmallWorld& world, std::size_t process, bool polls) {
    std::vector<Action> actions;
    std::size_t inputs = 0;
    for (std::size_t i = 0; i < world.channels.size(); ++i) {
        if (world.channels[i].outputter == process)
            actions.push_back({Action::output, i});
        if (world.channels[i].inputter == process)
            actions.push_back({Action::input, i}), ++inputs;
    }
    if (inputs > 1)
        actions.push_back({Action::alternate});
    if (inputs > 0 && polls)
        actions.push_back({Action::poll});
    return actions;
}

std::vector<SmallWorld> every_network(std::size_t channels) {
    std::vector<SmallWorld> found;
    lay({}, channels, 0, found);
    return found;
}

void for_every_program(SmallWorld network, std::size_t longest, bool polls,
                       const std::function<void(const SmallWorld&)>& check) {
    Programs(std::move(network), longest, polls, check).grow();
}

} // namespace placedpar::test
