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

/// Thrown through a process that acts differently from its history (ReplayLog). If the process catches the exception,
/// the next operation of the process throws again.
class ReplayDivergence {};

/// What the histories of all processes of a run have in common.
struct ReplaySession {
    /// The number of observations, of 16 bytes each, that the histories may still record. A run that needs more cannot
    /// be repeated.
    std::size_t room = 4'000'000;
    bool can_be_repeated = true;                 ///< false after an action that cannot be repeated
    bool has_diverged = false;                   ///< a process has acted differently from the history that it repeats
    std::function<void()> on_divergence = [] {}; ///< ends the run; may be called more than once
};

/// The history of a process in a run: its actions, and what it observed apart from messages. Such observations are the
/// guards that its ALTs chose, and the times that its clocks showed. With histories, a run can be repeated with other
/// data, without the slow simulation of the machine.
///
/// A process repeats its history with messages of other contents. Its ALTs choose the same guards, and its clocks show
/// the same times, as in the original run. Suppose that every process does exactly what its history says. Then the
/// machine would also take the same times with the new messages, because the machine sees only the processes' actions.
/// If a process acts differently, the repetition ends without a result. (T. LeBlanc and J. Mellor-Crummey, Debugging
/// parallel programs with Instant Replay, IEEE Transactions on Computers C-36(4), 1987. The order in which processes
/// run does not change the order of messages on a channel: G. Kahn, The semantics of a simple language for parallel
/// programming, 1974.)
///
/// REQUIRES of the program: the actions and outputs of a process depend only on the messages that it inputs and on the
/// observations recorded here. No process changes data that another process uses, even if both are components of one
/// PAR.
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

    /// Makes a history that records the actions of a process. REQUIRES: `name` is different for each process of the
    /// session; the session outlives the history.
    ReplayLog(ReplaySession& course, std::uint64_t name) : course_(course), name_(name) {}
    /// Makes a history that repeats the original. REQUIRES: the original outlives this history, and does not change.
    ReplayLog(ReplaySession& course, const ReplayLog& original)
        : course_(course), name_(original.name_), original_(&original) {
        next_component_ = original.components_.begin();
    }
    ReplayLog(const ReplayLog&) = delete;
    ReplayLog& operator=(const ReplayLog&) = delete;

    /// Returns whether the process repeats a history instead of recording one. Its computations and delays then take no
    /// time.
    bool repeats() const { return original_ != nullptr; }

    // The next functions are called for the process's actions, in order.

    /// Records an action. `what` identifies its object, such as the channel: a number below 2^56, or a hash, of which
    /// 56 bits are used. `how` has further details, in the same number of words for all actions of a kind. Throws
    /// ReplayDivergence if the process performs more actions than in the original run, or if any process has acted
    /// differently from its history. A different action is detected at the next call of observe() or at the end of the
    /// process.
    void record(Action action, std::uint64_t what, std::initializer_list<std::uint64_t> how = {}) {
        if (is_silent_)
            return;
        if (original_)
            require_another_action();
        note(action, what);
        for (std::uint64_t word : how)
            fingerprint_.mix(word);
    }
    /// Records an action without throwing, for actions that destructors may perform. If the action differs from the
    /// history, the session notes this.
    void record_quietly(Action, std::uint64_t what);
    /// Makes an observation: returns the result of `look`, or, when repeating, the recorded result. Actions of the
    /// process during `look` are not recorded separately. Throws ReplayDivergence if the original process did not make
    /// this observation at this point, or if any process has acted differently from its history. However, the first
    /// 100,000 readings of the clock then return 0 and do not throw, because destructors may read the clock.
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
    /// Records that the run cannot be repeated, because of an operation such as one that the machine would refuse.
    void record_unrepeatable();
    /// Returns the history of the next component of the process's PAR, which begins now.
    ReplayLog& component();
    /// Records that all components of the PAR have ended. From now on their histories are not used.
    void components_have_ended();
    /// Returns the number that identifies the next channel that the process makes, the same in each run.
    std::uint64_t next_channel();
    /// Records that the process has ended. Throws ReplayDivergence if its actions differ from the history that it
    /// repeats.
    void end();

private:
    struct Seen {
        std::uint64_t when_and_what; ///< number of actions before the observation, and the kind of observation
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
    const ReplayLog* original_ = nullptr; ///< null while the history is recorded
    Fingerprint fingerprint_;             ///< fingerprint of the actions
    std::uint64_t actions_ = 0;           ///< number of actions, including observations
    std::vector<Seen> seen_;              ///< observations of the original run
    std::size_t seen_again_ = 0;          ///< number of the original's observations that have been repeated
    std::uint64_t asked_in_vain_ = 0;
    std::uint64_t channels_ = 0; ///< number of channels that the process has made
    std::uint64_t begun_ = 0;    ///< number of components that have begun
    std::list<ReplayLog> components_;
    std::list<ReplayLog>::const_iterator next_component_; ///< next component of the original
    bool is_silent_ = false;                              ///< the current actions are part of an observation and are
                                                          ///< not recorded
};

} // namespace placedpar
