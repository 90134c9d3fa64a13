#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

class EventQueue;

/// Something that will happen at a moment of virtual time: a delay ends, a bit arrives. An event is in the
/// queue at most once; its destructor removes it from the queue.
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
    /// Runs outside every process: it must not wait and must not throw.
    virtual void happen() noexcept = 0;

    EventQueue* queue_ = nullptr;
    std::size_t position_ = 0;
};

/// The future: a heap of events keyed (time, priority, insertion or rank). kernel.hpp states the rule of ordering.
class EventQueue {
public:
    /// Order within an instant: requests for a wire, starts of packets on it, arrivals that wake processes, turns of
    /// executives, timers. Events of the first three kinds have ranks, the others go by insertion.
    enum Priority : std::uint64_t { request, start, arrival, turn, timer };

    ~EventQueue();
    bool empty() const { return heap_.empty(); }
    std::size_t size() const { return heap_.size(); }
    /// How many events have happened.
    std::uint64_t happened() const { return happened_; }
    /// REQUIRES: not empty().
    Time next_time() const { return heap_.front().time; }
    /// REQUIRES: the event is scheduled.
    Time time_of(const Event& event) const { return heap_[event.position_].time; }

    /// Schedules the event. Events of equal time and priority happen in the order in which they were scheduled.
    /// REQUIRES: the event is not scheduled.
    void schedule(Event&, Time, Priority);
    /// Schedules the event; events of equal time and priority happen in the order of their ranks (Kernel::new_ranks),
    /// however early a device scheduled them. REQUIRES: the event is not scheduled, and no other event of that time and
    /// priority has its rank.
    void schedule(Event&, Time, Priority, std::uint64_t rank);
    /// Has the same effect as cancel() followed by schedule(), at less cost.
    void reschedule(Event&, Time, Priority);
    void reschedule(Event&, Time, Priority, std::uint64_t rank);
    /// Removes the event from the queue, if it is scheduled.
    void cancel(Event&);
    /// Takes the first event out of the queue and lets it happen. REQUIRES: not empty().
    void happen_next();

private:
    struct Entry {
        Time time;
        std::uint64_t order; ///< priority in the upper 8 bits, insertion or rank below
        Event* event;
        /// Both parts are compared as one number, since the host processor cannot predict such a branch. Times are not
        /// negative.
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
