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

/// Thrown through a process that departs from its history. If the process catches the exception, it is unwound at its
/// next operation.
class ReplayDivergence {};

/// The state that the histories of all processes of a run share.
struct ReplaySession {
    /// The number of observations, of 16 bytes each, that the histories may still record. A run with more observations
    /// cannot be repeated.
    std::size_t room = 4'000'000;
    bool can_be_repeated = true;                 ///< false after an action that cannot be repeated
    bool has_diverged = false;                   ///< a process that repeats its history has departed from it
    std::function<void()> on_divergence = [] {}; ///< ends the run; may be called more than once
};

/// The history of a process in a run: its actions, and observations that no message carried. Such observations are the
/// guards that its alternations chose, and the times that its clocks showed.
///
/// A process can repeat its history with messages of other contents, and without a machine. Its alternations choose the
/// same guards, and its clocks show the same times, as in the original run. If every process does exactly what its
/// history says, a run on the machine with these messages would have the events of the original run. The machine and
/// the kernel know nothing else of a program, so by induction over the events each process would see what it saw in the
/// original run. If a process acts differently, the run has departed from its history. (T. LeBlanc and J.
/// Mellor-Crummey, Debugging parallel programs with Instant Replay, IEEE Transactions on Computers C-36(4), 1987. The
/// order of processes does not change the order of messages on a channel: G. Kahn, The semantics of a simple language
/// for parallel programming, 1974.)
///
/// REQUIRES of the program: the actions and outputs of a process depend only on the messages that it inputs and on the
/// observations recorded here. Two processes, even components of one PAR, share no data that one of them changes.
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

    /// Returns whether the process repeats a history. Its computations and delays then take no time.
    bool repeats() const { return original_ != nullptr; }

    // The next functions are called for the process's actions, in order.

    /// Records an action. `what` is a number below 2^56, or a hash; 56 bits of a hash are enough. `how` has details, in
    /// the same number of words for all actions of a kind. Throws ReplayDivergence if the process acts more often than
    /// its original, or if any process has departed from its history. A different action is detected at the next
    /// observation (observe()) or at the end of the process.
    void record(Action action, std::uint64_t what, std::initializer_list<std::uint64_t> how = {}) {
        if (is_silent_)
            return;
        if (original_)
            require_another_action();
        note(action, what);
        for (std::uint64_t word : how)
            fingerprint_.mix(word);
    }
    /// Records an action that destructors may perform. If the process departs from its history, this is recorded, but
    /// no exception is thrown.
    void record_quietly(Action, std::uint64_t what);
    /// Returns an observation that messages do not carry: the result of `look`, or, when repeating, the value that the
    /// original saw. Actions of the process during `look` are not recorded separately. Throws ReplayDivergence if the
    /// original did not make this observation at this point, or if any process has departed from its history. In these
    /// cases a reading of the clock returns 0 instead of throwing, because destructors may read the clock. Only after
    /// 100,000 such readings does it throw.
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
    /// Records an operation that cannot be repeated, or that the machine would refuse.
    void record_unrepeatable();
    /// Returns the history of the next component of a PAR. The component begins now.
    ReplayLog& component();
    /// Records that all components that had begun have ended. Their histories are not used any more.
    void components_have_ended();
    /// Returns the name of the next channel that the process makes.
    std::uint64_t next_channel();
    /// Records that the process has ended. Throws ReplayDivergence if it has departed from its original.
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
