#pragma once

#include "native/arrivals.hpp"
#include "runtime/kernel.hpp"
#include "runtime/surroundings.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace placedpar {
class Simulation;
} // namespace placedpar

namespace placedpar::native {

class Group;

/// The time for which a kernel without work checks for messages before its thread sleeps. To wake a thread takes about
/// as long.
inline constexpr Time most_patience = std::chrono::microseconds(20);

/// Connects a kernel with the other kernels of a native run, whose processes run in real time on several threads.
/// Receives their messages, and lets the thread sleep while it has nothing to do.
class Member final : public Surroundings {
public:
    Member(Group& group, Simulation& simulation) : group_(group), simulation_(simulation) {}

    /// Posts a message. May be called by any thread of the run. REQUIRES: the message is in no inbox.
    void post(Arrival&);
    /// Returns how long the kernel had nothing to do before the end of the work.
    Time rested() const { return rested_in_work_.value_or(rested_); }

    Time now() const override;
    void take_arrivals() noexcept override { inbox_.take(); }
    Rest rest(Time due, bool awaits_end) override;
    void wait_for_stop(bool failed) override;
    std::vector<const Kernel*> kernels() const override;
    void wait_for_reports() override;

private:
    friend class Group;
    enum class State { awake, asleep, asleep_for_time, stopped };

    bool comes_soon(Time due) const;

    Group& group_;
    Simulation& simulation_;
    Inbox inbox_;
    std::atomic<bool> sleeps_{false}; ///< a message must wake the thread
    // The mutex of the group guards the next members.
    State state_ = State::awake;
    bool awaits_end_ = false;
    std::uint64_t quiet_heard_ = 0; ///< the value of Group::times_quiet_ that this kernel has seen
    std::condition_variable woken_;

    Time rested_{};
    std::optional<Time> rested_in_work_; ///< set at the end of the work, if the kernel continues after it
};

/// The kernels of a native run, one for each thread. The group detects when no kernel has anything to do, so that the
/// run can end.
///
/// All kernels use one mutex to go to sleep, and a kernel sleeps only if its inbox is empty. A kernel that posts a
/// message stays awake until it has posted. Therefore nothing can wake any kernel if all kernels sleep without a time
/// to wake, or have stopped, and all inboxes are empty. The last kernel that goes to sleep detects this at once.
class Group {
public:
    Group() : begun_(std::chrono::steady_clock::now()) {}
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    /// Adds a kernel. REQUIRES: called before any kernel runs; the simulation outlives the group.
    Member& add(Simulation&);
    Member& member(std::size_t number) { return members_[number]; }
    std::size_t size() const { return members_.size(); }
    /// Starts the clock of the run.
    void begin() { begun_ = std::chrono::steady_clock::now(); }
    /// Ends the run of each kernel. May be called by any thread.
    void interrupt();

private:
    friend class Member;
    void note_if_quiet();
    void wake_all();
    void wait_for_all(std::unique_lock<std::mutex>&, std::size_t& arrived);

    std::chrono::steady_clock::time_point begun_;
    std::deque<Member> members_;
    std::mutex mutex_;
    std::condition_variable at_the_end_;
    std::uint64_t times_quiet_ = 0;
    bool is_over_ = false;
    bool interrupted_ = false;
    std::size_t stopped_ = 0, reported_ = 0;
};

} // namespace placedpar::native
