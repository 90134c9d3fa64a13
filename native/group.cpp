#include "native/group.hpp"

#include "runtime/simulation.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace placedpar::native {

namespace {

using Clock = std::chrono::steady_clock;

} // namespace

Member& Group::add(Simulation& simulation) {
    Member& member = members_.emplace_back(*this, simulation);
    simulation.run_among(member, static_cast<std::uint32_t>(members_.size() - 1));
    return member;
}

void Group::interrupt() {
    const std::lock_guard lock(mutex_);
    interrupted_ = true;
    for (Member& member : members_)
        member.simulation_.interrupt();
    wake_all();
}

void Group::wake_all() {
    for (Member& member : members_)
        member.woken_.notify_one();
}

/// If no kernel has anything to do, increments `times_quiet_` and wakes all kernels. A kernel that has not yet noticed
/// the previous increment counts as busy.
void Group::note_if_quiet() {
    const bool is_quiet = std::ranges::all_of(members_, [&](const Member& member) {
        return member.state_ == Member::State::stopped ||
               (member.state_ == Member::State::asleep && member.inbox_.empty() && member.quiet_heard_ == times_quiet_);
    });
    if (!is_quiet)
        return;
    ++times_quiet_;
    is_over_ = std::ranges::none_of(members_, &Member::awaits_end_);
    wake_all();
}

Time Member::now() const { return std::chrono::duration_cast<Time>(Clock::now() - group_.begun_); }

void Member::post(Arrival& arrival) {
    inbox_.post(arrival);
    if (!sleeps_.load())
        return;
    const std::lock_guard lock(group_.mutex_); // the thread may be about to sleep
    woken_.notify_one();
}

/// Looks for messages for a short time. Returns whether the kernel has something to do.
bool Member::comes_soon(Time due) const {
    static const unsigned cores = std::thread::hardware_concurrency(); // this call takes microseconds
    const bool has_core = group_.size() <= cores;
    const Time until = std::min(due, now() + (has_core ? most_patience : Time{0}));
    do {
        if (!inbox_.empty())
            return true;
    } while (now() < until);
    return due <= until;
}

Surroundings::Rest Member::rest(Time due, bool awaits_end) {
    const Time since = now();
    struct Counted {
        ~Counted() { member.rested_ += member.now() - since; }
        Member& member;
        Time since;
    } counted{*this, since};
    if (comes_soon(due))
        return Rest::over;
    std::unique_lock lock(group_.mutex_);
    sleeps_ = true;
    awaits_end_ = awaits_end;
    state_ = due == Time::max() ? State::asleep : State::asleep_for_time;
    group_.note_if_quiet();
    const auto is_woken = [&] { return !inbox_.empty() || group_.interrupted_ || group_.times_quiet_ != quiet_heard_; };
    if (due == Time::max())
        woken_.wait(lock, is_woken);
    else
        woken_.wait_until(lock, group_.begun_ + std::chrono::duration_cast<Clock::duration>(due), is_woken);
    state_ = State::awake;
    awaits_end_ = false;
    sleeps_ = false;
    if (group_.is_over_)
        return Rest::forever;
    if (std::exchange(quiet_heard_, group_.times_quiet_) == group_.times_quiet_)
        return Rest::over;
    if (!rested_in_work_)
        rested_in_work_ = rested_ + now() - since;
    return Rest::quiet;
}

/// Waits until all kernels have called this function with the same counter `arrived`. Each point of the program at
/// which kernels wait for each other has its own counter.
void Group::wait_for_all(std::unique_lock<std::mutex>& lock, std::size_t& arrived) {
    if (++arrived == members_.size())
        at_the_end_.notify_all();
    at_the_end_.wait(lock, [&] { return arrived == members_.size(); });
}

void Member::wait_for_stop(bool failed) {
    if (failed)
        group_.interrupt();
    std::unique_lock lock(group_.mutex_);
    state_ = State::stopped;
    group_.note_if_quiet();
    group_.wait_for_all(lock, group_.stopped_);
}

std::vector<const Kernel*> Member::kernels() const {
    std::vector<const Kernel*> all;
    for (const Member& member : group_.members_)
        all.push_back(&member.simulation_.kernel());
    return all;
}

void Member::wait_for_reports() {
    std::unique_lock lock(group_.mutex_);
    group_.wait_for_all(lock, group_.reported_);
}

} // namespace placedpar::native
