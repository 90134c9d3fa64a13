#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

class EventQueue;

/// Something that will happen at a moment of virtual time, such as the end of a delay or the arrival of a bit. An event
/// is in the queue at most once. Its destructor removes it from the queue.
class Event {
public:
    Event() = default;
    Event(const Event&) = delete;
    Event& operator=(const Event&) = delete;
    bool scheduled() const { return queue_ != nullptr; }

protected:
    ~Event();

private:
    friend class EventQueue;
    /// Performs the event. The kernel calls this function outside of every process. The function must not wait or
    /// throw.
    virtual void happen() noexcept = 0;

    EventQueue* queue_ = nullptr;
    std::size_t position_ = 0;
};

/// The queue of future events. It is a heap, ordered by time, then by priority, then by rank or order of insertion. A
/// rank is a number that a device has reserved for its events, so that their order does not depend on the time of
/// scheduling.
class EventQueue {
public:
    /// The order within an instant: requests for a wire, starts of packets on the wire, arrivals that wake processes,
    /// turns of executives, timers. Events of the first three kinds happen in the order of their ranks, the others in
    /// the order in which they were scheduled.
    enum Priority : std::uint64_t { request, start, arrival, turn, timer };

    ~EventQueue();
    bool empty() const { return heap_.empty(); }
    std::size_t size() const { return heap_.size(); }
    /// Returns how many events have happened.
    std::uint64_t happened() const { return happened_; }
    /// REQUIRES: not empty().
    Time next_time() const { return heap_.front().time; }
    /// REQUIRES: the event is scheduled.
    Time time_of(const Event& event) const { return heap_[event.position_].time; }

    /// Schedules the event. Events of equal time and priority happen in the order in which they were scheduled.
    /// REQUIRES: the event is not scheduled.
    void schedule(Event&, Time, Priority);
    /// Schedules the event. Events of equal time and priority happen in the order of their ranks (Kernel::new_ranks).
    /// REQUIRES: the event is not scheduled, and no other event of this time and priority has the same rank.
    void schedule(Event&, Time, Priority, std::uint64_t rank);
    /// Do the same as cancel() followed by schedule(), at less cost.
    void reschedule(Event&, Time, Priority);
    void reschedule(Event&, Time, Priority, std::uint64_t rank);
    /// Removes the event from the queue, if it is scheduled.
    void cancel(Event&);
    /// Removes the first event from the queue and performs it. REQUIRES: not empty().
    void happen_next();

private:
    struct Entry {
        Time time;
        std::uint64_t order; ///< priority in the upper 8 bits, insertion or rank in the lower bits
        Event* event;
        /// Returns time and order as one number. To compare them one after the other would need a branch that the host
        /// processor cannot predict. REQUIRES: the time is not negative.
        __extension__ unsigned __int128 key() const {
            return static_cast<decltype(key())>(static_cast<std::uint64_t>(time.count())) << 64 | order;
        }
        bool before(const Entry& other) const { return key() < other.key(); }
    };
    static std::size_t earliest(const Entry* heap, std::size_t first, std::size_t end);
    static void fetch_children(const Entry* heap, std::size_t first);
    void put(Entry, std::size_t position);
    void sift_up(Entry, std::size_t position);
    void sift_down(Entry, std::size_t position);
    void place(Entry, std::size_t position);
    void remove(std::size_t position);

    std::vector<Entry> heap_;
    std::uint64_t inserted_ = 0, happened_ = 0;
};

} // namespace placedpar
