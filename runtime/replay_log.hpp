#pragma once

#include "runtime/fingerprint.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <list>
#include <vector>

namespace placedpar {

/// Thrown through a process that departs from its history. A process that catches the exception is unwound at its next
/// operation.
class ReplayDivergence {};

/// The state that is shared by the histories of all processes of one run.
struct ReplaySession {
    /// Number of readings that the histories may still record, at 16 bytes each. A run with more is not repeated.
    std::size_t room = 4'000'000;
    bool can_be_repeated = true;                 ///< no process has done anything that cannot be repeated
    bool has_diverged = false;                   ///< a process that repeats its history has departed from it
    std::function<void()> on_divergence = [] {}; ///< ends the run; may be called more than once
};

/// What a process did in a run, and what it saw there that no message told it: which guards its alternations chose, and
/// what clocks showed.
///
/// A process can repeat its history with other messages and without a machine: its alternations choose, and its clocks
/// show, what they did in the original run. If all processes do exactly what their histories say, a run on the machine
/// with these messages would have taken the same course, event for event. The reason is that the machine and the kernel
/// know nothing else of a program: by induction over the events, each process would have seen what it saw in the
/// original run. If a process does something else, the run has departed from its history. (T. LeBlanc and J.
/// Mellor-Crummey, Debugging parallel programs with Instant Replay, IEEE Transactions on Computers C-36(4), 1987; that
/// messages come in the same order on each channel however processes take turns is G. Kahn's, The semantics of a simple
/// language for parallel programming, 1974.)
///
/// REQUIRES of the program: what a process does, and what it sends, follows from its messages and from what is noted
/// here. No two processes share what one of them changes, not even components of one PAR.
class ReplayLog {
public:
    enum class Action : std::uint64_t {
        output,
        input,
        computation,
        alternation,
        delay,
        timer_wait,
        after_work,
        parallel,
        measurement,
        now,
        timer,
        tick,
        bits
    };

    /// Makes a history that records what a process does. REQUIRES: `name` is different for each process of the course;
    /// the course outlives the history.
    ReplayLog(ReplaySession& course, std::uint64_t name) : course_(course), name_(name) {}
    /// Makes a history that repeats the original. REQUIRES: the original outlives it, and does not change meanwhile.
    ReplayLog(ReplaySession& course, const ReplayLog& original)
        : course_(course), name_(original.name_), original_(&original) {
        next_component_ = original.components_.begin();
    }
    ReplayLog(const ReplayLog&) = delete;
    ReplayLog& operator=(const ReplayLog&) = delete;

    /// Returns whether the process repeats a history; its computations and delays take no time then.
    bool repeats() const { return original_ != nullptr; }

    // Called for the process's actions, in their order.

    /// Records an action. `what` is less than 2^56, or a hash of which 56 bits suffice. `how` always has the same
    /// number of words for the same kind of action. Throws ReplayDivergence if the process acts more often than in its
    /// original, or if any process has departed. A different action is detected at the next observation (observe()) or
    /// at the end of the process.
    void record(Action action, std::uint64_t what, std::initializer_list<std::uint64_t> how = {}) {
        if (is_silent_)
            return;
        if (original_)
            require_another_action();
        note(action, what);
        for (std::uint64_t word : how)
            fingerprint_.mix(word);
    }
    /// Records an action that destructors may do: a departure is noted, but not thrown.
    void record_quietly(Action, std::uint64_t what);
    /// Returns an observation that messages do not carry: the result of `look`, or, when repeating, the value that the
    /// original saw. Actions of the process during `look` are not recorded apart. Throws ReplayDivergence if the
    /// original did not make this observation at this point, or if any process has departed. Reading the clock then
    /// returns 0 and does not throw, since destructors may do it; it throws only after 100,000 such reads.
    template <std::invocable Look>
    std::int64_t observe(Action what, Look look) {
        if (is_silent_)
            return look();
        if (original_)
            return observed_then(what);
        is_silent_ = true;
        std::int64_t seen = look();
        is_silent_ = false;
        note_observation(what, seen);
        return seen;
    }
    /// Notes an operation that cannot be repeated, or that would be refused on the machine.
    void record_unrepeatable();
    /// Returns the history of the next component of a PAR, which begins now.
    ReplayLog& component();
    /// Notes that all components that had begun have ended. Their histories are not used any more.
    void components_have_ended();
    /// Returns the name of the next channel that the process makes.
    std::uint64_t next_channel();
    /// Notes that the process has ended. Throws ReplayDivergence if it has departed from its original.
    void end();

private:
    struct Seen {
        std::uint64_t when_and_what; ///< how many actions were before it, and what it asked for
        std::int64_t value;
    };
    std::uint64_t when_and_what(Action what) const { return actions_ << 8 | static_cast<std::uint64_t>(what); }
    void note(Action action, std::uint64_t what) {
        ++actions_;
        fingerprint_.mix(static_cast<std::uint64_t>(action) << 56 ^ what);
    }
    void require_another_action() {
        if (course_.has_diverged || actions_ == original_->actions_)
            diverge();
    }
    void note_observation(Action what, std::int64_t seen);
    void take_room(std::size_t readings);
    std::int64_t observed_then(Action what);
    [[noreturn]] void diverge();
    void diverge_quietly();

    ReplaySession& course_;
    std::uint64_t name_;
    const ReplayLog* original_ = nullptr; ///< null while it is noted
    Fingerprint fingerprint_;             ///< of the actions
    std::uint64_t actions_ = 0;           ///< what it saw included
    std::vector<Seen> seen_;              ///< of the original
    std::size_t seen_again_ = 0;          ///< how many of its original's
    std::uint64_t asked_in_vain_ = 0;
    std::uint64_t channels_ = 0; ///< that it has made
    std::uint64_t begun_ = 0;    ///< components
    std::list<ReplayLog> components_;
    std::list<ReplayLog>::const_iterator next_component_; ///< of its original
    bool is_silent_ = false;                              ///< what it does is a part of something that is noted
};

} // namespace placedpar
