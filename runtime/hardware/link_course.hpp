#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link_packets.hpp"
#include "runtime/hardware/link_period.hpp"
#include "runtime/hardware/link_state.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar {
class Kernel;
class Process;
} // namespace placedpar

namespace placedpar::hardware {

/// What the course of a link calls when a packet begins or a step was performed. A Link implements it.
class LinkObserver {
public:
    /// Returns a time before which all packets that begin reach the other end, at the present speed, and need no call
    /// of packet_begins. Called only for a link that may lose packets.
    virtual Time steady_until() const = 0;
    /// Decides whether a packet that is about to begin reaches the other end. Called only for a link that may lose
    /// packets.
    virtual LinkState::Fate packet_begins(const LinkState::Next&) = 0;
    /// Acts on a step that was performed and visible. It may change the state, but must not begin a Touch of another
    /// link. Returns the process that the step wakes; null if there is none.
    virtual Process* step_performed(LinkState&, const LinkState::Next&, const LinkState::Outcome&) = 0;

protected:
    ~LinkObserver() = default;
};

/// The course of a link through time. Only the steps that a process, a trace or a fault can see are events. The other
/// steps are performed when the state is read or changed. So a link keeps the state of the time at which it was last
/// touched, and has one event in the kernel's queue: its next visible step. To find that step, a copy of the state is
/// run ahead.
class LinkCourse final : private Event {
public:
    LinkCourse(Kernel&, const PacketTimes&, LinkObserver&);

    /// Lets its owner change the state of the link. The constructor brings the state up to now; the destructor finds
    /// the next visible step. One Touch may stand within another: the outer one looks ahead again.
    class Touch {
    public:
        explicit Touch(LinkCourse& course) : course_(course) { course_.catch_up_and_stay(); }
        ~Touch() { course_.look_ahead(); }
        Touch(const Touch&) = delete;
        Touch& operator=(const Touch&) = delete;
        LinkState* operator->() { return course_.state_; }
        LinkState& operator*() { return *course_.state_; }
        /// Lets the next packet of a direction begin, if it is due and its wire is free.
        void begin_if_free(std::size_t direction);

    private:
        LinkCourse& course_;
    };

    /// The state of the last Touch. Members that only a Touch changes are right at any time.
    const LinkState& touched() const { return *state_; }
    /// The state of now. A packet that begins now may have begun or not.
    const LinkState& state();

    /// Prefetches what bytes_begun_before() reads.
    void fetch() const { __builtin_prefetch(&period_); }
    /// Returns how many bytes of the part under way have begun before now. Bytes that begin now are left out, since the
    /// order of simultaneous events would decide about them.
    std::uint32_t bytes_begun_before(Time now, std::size_t direction) {
        if (period_.is_simple_around(now)) [[likely]]
            return period_.part_bytes[direction] - period_.bytes_left(direction, now - Time{1});
        catch_up(now);
        const LinkPackets::Stream& stream = state_->packets.streams[direction];
        std::uint32_t bytes = state_->directions[direction].part_bytes - stream.bytes_left;
        return bytes > 0 && stream.last_start >= now ? bytes - 1 : bytes;
    }

    /// Notes that a receiver waits, and returns true, if nothing is under way in the direction. Since the next visible
    /// step stays what it was, this needs no Touch. Otherwise changes nothing and returns false.
    bool waits_idly(std::size_t direction);

    // The following make more steps visible. Call the first two before the run.
    /// Makes every step an event. Tests compare such a run with the usual one.
    void show_every_step() { shows_every_step_ = true; }
    /// Makes packets visible that a fault may strike.
    void show_faults() { state_->may_lose_packets = true; }
    /// Says whether the trace shows bytes of the direction as under way. While it does not, the next byte is visible;
    /// while it does, the last byte is.
    void trace_knows(std::size_t direction, bool carries) { trace_carries_[direction] = carries; }
    bool trace_carries(std::size_t direction) const { return trace_carries_[direction]; }

private:
    void happen() noexcept override;
    void fetch_states() const;
    Process* perform(const LinkState::Next&);
    void catch_up(Time now) {
        if (now >= quiet_until_) [[unlikely]]
            perform_steps_until(now);
    }
    void perform_steps_until(Time now);
    void catch_up_and_stay();
    void perform_unseen_steps(Time until);
    void forget_run() {
        runs_from_ = never;
        period_.forget();
    }
    void look_ahead();
    void run_ahead(LinkState::Next);
    bool run_packets(LinkState&);
    void schedule(const LinkState::Next&);
    void stand_still();
    bool is_visible(const LinkState&, const LinkState::Next&) const;
    bool trace_sees_byte(const LinkState&, std::size_t direction) const;
    bool may_run(const LinkState::Next&) const;

    // The members stand in the order of use, which saves lines of the cache.
    Time quiet_until_{};                    ///< no step happens earlier, so that `state_` is the state of now
    Time runs_from_ = never, runs_until_{}; ///< between these times packets run by themselves
    LinkState* state_ = nullptr;            ///< the state of the last Touch
    LinkState* ahead_ = nullptr;            ///< the state just before the next visible step
    LinkPeriod period_;                     ///< period of the packets between the two
    std::array<LinkState, 2> states_;
    LinkState::Next next_; ///< the next visible step
    /// Whether there is a next visible step, and whether it is the next step of `state_` or that of `ahead_`.
    enum class Ahead : std::uint8_t { nowhere, at_once, after_others };
    Ahead where_next_ = Ahead::nowhere;
    bool shows_every_step_ = false;
    std::array<bool, 2> trace_carries_{};
    Time steady_until_ = never; ///< see LinkObserver
    std::uint64_t first_rank_;
    Kernel& kernel_;
    const PacketTimes& times_;
    LinkObserver& observer_;
};

} // namespace placedpar::hardware
