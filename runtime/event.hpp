#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

class EventQueue;

/// Something that is to happen at a point of virtual time: a delay that ends, a bit that arrives. It is in
/// the queue at most once, and leaves it when it is destroyed.
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
    /// What happens. Runs outside every process: it must not wait and must not throw.
    virtual void happen() noexcept = 0;

    EventQueue* queue_ = nullptr;
    std::size_t position_ = 0;
};

/// The future: a heap of events keyed (time, priority, insertion). Events of one instant happen by
/// priority, lowest first, and within a priority in the order in which they were scheduled; those of links
/// in the order of their ranks, so that it makes no difference when a link learnt that they would happen.
class EventQueue {
public:
    /// What goes first within an instant. On links first whatever asks for an acknowledge, then what starts
    /// bytes, then what wakes processes; then the processors' turns, then timers.
    enum Priority : std::uint64_t { acknowledge, start, arrival, processor, timer };

    ~EventQueue();
    bool empty() const { return heap_.empty(); }
    /// REQUIRES: not empty().
    Time next_time() const { return heap_.front().time; }

    /// REQUIRES: the event is not scheduled.
    void schedule(Event&, Time, Priority);
    /// The same for the events of links. REQUIRES: no other event of that time and priority has this rank.
    void schedule(Event&, Time, Priority, std::uint64_t rank);
    /// No effect on an event that is not scheduled.
    void cancel(Event&);
    /// Takes the first event out of the queue and lets it happen. REQUIRES: not empty().
    void happen_next();

private:
    struct Entry {
        Time time;
        std::uint64_t order; ///< priority in the upper 8 bits, insertion or rank below
        Event* event;
        bool before(const Entry& other) const { return time != other.time ? time < other.time : order < other.order; }
    };
    void put(Entry, std::size_t position);
    void sift_up(Entry, std::size_t position);
    void sift_down(Entry, std::size_t position);
    void remove(std::size_t position);

    std::vector<Entry> heap_;
    std::uint64_t inserted_ = 0;
};

} // namespace placedpar
