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

/// Is told what happens on a link: the link itself.
class LinkObserver {
public:
    /// Packets that begin from now until that moment come over, at the present speed of the link, with nothing to
    /// note. Asked, like packet_begins, of a link that may lose packets.
    virtual Time steady_until() const = 0;
    /// A packet is about to begin. Says what becomes of it.
    virtual LinkState::Fate packet_begins(const LinkState::Next&) = 0;
    /// A step was taken. Returns the process that it wakes; null if there is none.
    virtual Process* taken(LinkState&, const LinkState::Next&, const LinkState::Outcome&) = 0;

protected:
    ~LinkObserver() = default;
};

/// The course of a link through time. Of all steps of its state only those that others can see are events; the others
/// are taken when somebody looks, or acts on the link. So a link keeps the state that it had when it was touched last,
/// and stands in the kernel's future once: with its next visible step. To find that, a copy of the state is run ahead.
class LinkCourse final : private Event {
public:
    LinkCourse(Kernel&, const PacketTimes&, LinkObserver&);

    /// Somebody acts on the link, at this moment: the state is that of now, may be changed, and where it leads to is
    /// found when this object ends.
    class Touch {
    public:
        explicit Touch(LinkCourse& course) : course_(course) { course_.catch_up_and_stay(); }
        ~Touch() { course_.look_ahead(); }
        Touch(const Touch&) = delete;
        Touch& operator=(const Touch&) = delete;
        LinkState* operator->() { return course_.state_; }
        LinkState& operator*() { return *course_.state_; }
        /// Lets the packet that was asked for begin, if its wire is free.
        void begin_if_free(std::size_t direction);

    private:
        LinkCourse& course_;
    };

    /// As it was touched last: what changes only then, it holds at any time.
    const LinkState& touched() const { return *state_; }
    /// As it is now; what begins in this instant may have begun or not.
    const LinkState& state();

    /// Begins to fetch what bytes_begun_before looks at.
    void fetch() const { __builtin_prefetch(&period_); }
    /// Of the part under way in a direction, before this moment, which is now: whether one that begins now has begun
    /// yet depends on the order of this instant's events.
    std::uint32_t bytes_begun_before(Time now, std::size_t direction) {
        if (period_.is_simple_around(now)) [[likely]]
            return period_.part_bytes[direction] - period_.bytes_left(direction, now - Time{1});
        catch_up(now);
        const LinkPackets::Stream& stream = state_->packets.streams[direction];
        std::uint32_t bytes = state_->directions[direction].part_bytes - stream.bytes_left;
        return bytes > 0 && stream.last_start >= now ? bytes - 1 : bytes;
    }

    /// The receiver of a direction in which nothing is under way asks: that is a step towards nothing, so that nobody
    /// need look ahead. Returns whether it is such a direction.
    bool waits_idly(std::size_t direction);

    // What is visible besides what processes see. REQUIRES: before the run, except for the last.
    /// Every step is, as the reference by which all that saves events is tested.
    void show_every_step() { shows_every_step_ = true; }
    /// Packets are that faults may strike.
    void show_faults() { state_->may_lose_packets = true; }
    /// Of a direction that is traced, the byte after which the trace knows that bytes follow each other is the first,
    /// and then the last one.
    void trace_knows(std::size_t direction, bool carries) { trace_carries_[direction] = carries; }
    bool trace_carries(std::size_t direction) const { return trace_carries_[direction]; }

private:
    void happen() noexcept override;
    void fetch_states() const;
    Process* take(const LinkState::Next&);
    void catch_up(Time now) {
        if (now >= quiet_until_) [[unlikely]]
            take_steps_until(now);
    }
    void take_steps_until(Time now);
    void catch_up_and_stay();
    void take_unseen_steps(Time until);
    void forget_run() {
        runs_from_ = never;
        period_.forget();
    }
    void look_ahead();
    void run_ahead(LinkState::Next);
    bool run(LinkState&);
    void schedule(const LinkState::Next&);
    void stand_still();
    bool is_visible(const LinkState&, const LinkState::Next&) const;
    bool trace_sees_byte(const LinkState&, std::size_t direction) const;
    bool may_run(const LinkState::Next&) const;

    // In the order of use, in lines of the cache.
    Time quiet_until_{};                    ///< until then the state is that of now
    Time runs_from_ = never, runs_until_{}; ///< when packets run by themselves, within what was looked at
    LinkState* state_ = nullptr;            ///< when it was touched last
    LinkState* ahead_ = nullptr;            ///< just before the next visible step
    LinkPeriod period_;                     ///< of the packets between the two
    std::array<LinkState, 2> states_;
    LinkState::Next next_; ///< the visible step
    enum class Ahead : std::uint8_t { nowhere, at_once, after_others };
    Ahead next_is_ = Ahead::nowhere; ///< the visible step: none, that of `state_`, that of `ahead_`
    bool shows_every_step_ = false;
    std::array<bool, 2> trace_carries_{};
    Time steady_until_ = never; ///< packets that begin before come over, at the speed of now
    std::uint64_t first_rank_;
    Kernel& kernel_;
    const PacketTimes& times_;
    LinkObserver& observer_;
};

} // namespace placedpar::hardware
