#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace placedpar::test {

/// What a process of a small world does in one step.
struct Action {
    enum Kind {
        output,    ///< to `channel`
        input,     ///< from `channel`
        alternate, ///< on the channels of `guards`
        poll       ///< the same with SKIP behind them
    } kind;
    std::size_t channel = 0;  ///< of an output or input
    std::uint32_t guards = 0; ///< of an alternation: a bit for each channel

    bool is_alternation() const { return kind == alternate || kind == poll; }
    bool is_guarded_by(std::size_t c) const { return is_alternation() && (guards >> c & 1) != 0; }
    bool takes(std::size_t c) const { return (kind == input && channel == c) || is_guarded_by(c); }
};

/// A network of three processes, some of them perhaps without actions, and the channels between them.
struct SmallWorld {
    struct Ends {
        std::size_t outputter, inputter;
    };
    std::vector<Ends> channels;
    std::array<std::vector<Action>, 3> processes;

    /// "0>1 2>1 | !0 !0 | ?0 A01 | !1"
    std::string text() const;
    /// The world of such a text. Throws std::invalid_argument for another text.
    static SmallWorld of(const std::string& text);
};

/// What CSP allows a world to do, by looking at all of its states. Where it stands is how many actions each
/// process has behind it; a set of such states, since a poll is not seen from outside.
class Interpreter {
public:
    using State = std::array<std::uint8_t, 3>;
    using States = std::set<State>;

    explicit Interpreter(const SmallWorld& world) : world_(world) {}

    States start() const { return after_polls({State{}}); }
    /// Where the world can stand after a communication on the channel; none if it cannot happen.
    States after(const States&, std::size_t channel) const;
    /// Whether nothing more can happen in some of the states, and whether the world may then be called
    /// completed, or deadlocked.
    bool can_end(const States&, bool completed) const;
    /// Everywhere that the world can come to stand. REQUIRES: no process has more than 15 actions.
    std::vector<State> reachable() const;
    /// All traces from start to end.
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
