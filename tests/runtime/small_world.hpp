#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace placedpar::test {

/// A step of a process in a small world.
struct Action {
    enum Kind {
        output,    ///< to `channel`
        input,     ///< from `channel`
        alternate, ///< on the channels of `guards`
        poll       ///< like `alternate`, with SKIP as the last guard
    } kind;
    std::size_t channel = 0;  ///< for an output or input
    std::uint32_t guards = 0; ///< for an alternation: a bit for each channel

    bool is_alternation() const { return kind == alternate || kind == poll; }
    bool is_guarded_by(std::size_t c) const { return is_alternation() && (guards >> c & 1) != 0; }
    bool takes(std::size_t c) const { return (kind == input && channel == c) || is_guarded_by(c); }
};

/// A network of three processes, which may have no actions, and the channels between them.
struct SmallWorld {
    struct Ends {
        std::size_t outputter, inputter;
    };
    std::vector<Ends> channels;
    std::array<std::vector<Action>, 3> processes;

    /// Returns a text such as "0>1 2>1 | !0 !0 | ?0 A01 | !1".
    std::string text() const;
    /// Returns the world that such a text describes. Throws std::invalid_argument for another text.
    static SmallWorld of(const std::string& text);
};

/// Finds what CSP allows in a world, by exploring all of its states. A state is the number of actions that each process
/// has done. Sets of states are needed because a poll cannot be seen from outside.
class Interpreter {
public:
    using State = std::array<std::uint8_t, 3>;
    using States = std::set<State>;

    explicit Interpreter(const SmallWorld& world) : world_(world) {}

    States start() const { return after_polls({State{}}); }
    /// Returns the possible states after a communication on the channel; empty if it cannot happen.
    States after(const States&, std::size_t channel) const;
    /// Returns whether in some of the states nothing more can happen, and the world may be called completed (or
    /// deadlocked).
    bool can_end(const States&, bool completed) const;
    /// Returns whether CSP allows a course: communications on the channels that the trace names, and then its end.
    bool allows(const std::string& trace, bool completed) const;
    /// Returns all reachable states. REQUIRES: no process has more than 15 actions.
    std::vector<State> reachable() const;
    /// Returns all traces from the start to an end.
    std::set<std::string> traces() const;

private:
    const Action* next(const State&, std::size_t process) const;
    bool offers_input(const State&, std::size_t channel) const;
    bool can_communicate(const State&, std::size_t channel) const;
    States after_polls(States) const;
    State communicated(State, std::size_t channel) const;
    std::vector<State> next_states(const State&) const;
    void follow(const States&, const std::string& trace, std::set<std::string>& found) const;

    const SmallWorld& world_;
};

} // namespace placedpar::test
