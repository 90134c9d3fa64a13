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

/// The callbacks of a LinkCourse: a packet begins, or a step has been performed. A Link implements them. A packet is a
/// byte or an acknowledge on a wire.
class LinkObserver {
public:
    /// Returns a time up to which no packet is lost and the speed does not change, so that packet_begins() need not be
    /// called. Called only for a link that may lose packets.
    virtual Time steady_until() const = 0;
    /// Decides whether a packet that begins now reaches the other end. Called only for a link that may lose packets.
    virtual LinkState::Fate packet_begins(const LinkState::Next&) = 0;
    /// Acts on a visible step that was performed. Returns the process that the step wakes, or null. May change the
    /// state, but must not begin a Touch of another link.
    virtual Process* step_performed(LinkState&, const LinkState::Next&, const LinkState::Outcome&) = 0;

protected:
    ~LinkObserver() = default;
};

/// Advances the state of a link in time. An event for each byte would make simulations slow. So only visible steps are
/// events, that is, steps that a process, a trace or a fault can see. The other steps are performed later, when the
/// state is read or changed. The link has one event in the kernel's queue: its next visible step. To find this step, a
/// copy of the state is run ahead.
class LinkCourse final : private Event {
public:
    LinkCourse(Kernel&, const PacketTimes&, LinkObserver&);

    /// Gives access to the state of the link, in order to change it. The constructor brings the state up to now; the
    /// destructor finds the next visible step. Touches may be nested.
    class Touch {
    public:
        explicit Touch(LinkCourse& course) : course_(course) { course_.catch_up_and_stay(); }
        ~Touch() { course_.look_ahead(); }
        Touch(const Touch&) = delete;
        Touch& operator=(const Touch&) = delete;
        LinkState* operator->() { return course_.state_; }
        LinkState& operator*() { return *course_.state_; }
        /// Begins the next packet of a direction if the packet is due and its wire is free.
        void begin_if_free(std::size_t direction);

    private:
        LinkCourse& course_;
    };

    /// Returns the state at the last Touch. Only members that steps do not change are certainly correct now.
    const LinkState& touched() const { return *state_; }
    /// Returns the state now. A packet that begins now may or may not be included.
    const LinkState& state();

    /// Returns whether no step will happen before the next Touch. Returns false if a byte has begun at the present
    /// time.
    bool is_still() const;
    /// Prefetches the data that bytes_begun_before() reads.
    void fetch() const { __builtin_prefetch(&period_); }
    /// Returns how many bytes of the current part began before `now`. Bytes that begin at `now` are excluded, because
    /// they depend on the order of simultaneous events.
    std::uint32_t bytes_begun_before(Time now, std::size_t direction) {
        if (period_.is_simple_around(now)) [[likely]]
            return period_.part_bytes[direction] - period_.bytes_left(direction, now - Time{1});
        catch_up(now);
        const LinkPackets::Stream& stream = state_->packets.streams[direction];
        std::uint32_t bytes = state_->directions[direction].part_bytes - stream.bytes_left;
        return bytes > 0 && stream.last_start >= now ? bytes - 1 : bytes;
    }

    /// If the direction is idle, notes that a receiver waits, and returns true. This needs no Touch, because the next
    /// visible step does not change. Otherwise returns false and changes nothing.
    bool waits_idly(std::size_t direction);

    // The following functions make more steps visible. Call the first two before the run.
    /// Makes every step an event. Tests compare such runs with usual runs.
    void show_every_step() { every_step_from_ = Time{0}; }
    /// Makes the start of each packet that a fault may strike a visible step.
    void show_faults() { state_->may_lose_packets = true; }
    /// States whether the trace shows the direction as carrying bytes. Then the start of the part's last byte is a
    /// visible step; otherwise, the start of the direction's next byte.
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
    Time runs_before() const;
    bool run_packets(Time from);
    void schedule(const LinkState::Next&);
    bool is_visible(const LinkState&, const LinkState::Next&) const;
    bool trace_sees_byte(const LinkState&, std::size_t direction) const;

    // The members are in the order of use, to save cache lines.
    Time quiet_until_{};                    ///< no step happens before this time, so `state_` is the state now
    Time runs_from_ = never, runs_until_{}; ///< between these times many packets are computed together
    LinkState* state_ = nullptr;            ///< state at the last Touch
    LinkState* ahead_ = nullptr;            ///< the state just before the next visible step
    LinkPeriod period_;                     ///< the regular pattern of packets between these two states
    std::array<LinkState, 2> states_;
    LinkState::Next next_; ///< the next visible step
    /// States whether the next visible step is the next step of `state_` (at_once) or of `ahead_` (after_others).
    enum class Ahead : std::uint8_t { at_once, after_others };
    Ahead where_next_ = Ahead::at_once;
    std::array<bool, 2> trace_carries_{};
    Time every_step_from_ = too_late; ///< from this time on every step is visible; a step at `too_late` is always
                                      ///< visible
    Time steady_until_ = never;       ///< result of LinkObserver::steady_until()
    std::uint64_t first_rank_;
    Kernel& kernel_;
    const PacketTimes& times_;
    LinkObserver& observer_;
};

} // namespace placedpar::hardware
