#include "runtime/event.hpp"

#include <algorithm>
#include <cassert>

namespace placedpar {

/// The number of children of a node of the heap. With four children the heap is half as deep as with two, and each step
/// down reads adjacent cache lines.
constexpr std::size_t children = 4;

/// The number of events that fit into a second-level cache of 1 Mbyte (our estimate). With more events, prefetching is
/// worth its time.
constexpr std::size_t events_in_a_cache = 30'000;

constexpr std::uint64_t order(EventQueue::Priority priority, std::uint64_t rank) {
    return (std::uint64_t{priority} << 56) | rank;
}

Event::~Event() {
    if (queue_)
        queue_->cancel(*this);
}

EventQueue::~EventQueue() {
    for (auto& entry : heap_)
        entry.event->queue_ = nullptr;
}

void EventQueue::schedule(Event& event, Time time, Priority priority) { schedule(event, time, priority, inserted_++); }

void EventQueue::schedule(Event& event, Time time, Priority priority, std::uint64_t rank) {
    assert(!event.scheduled());
    heap_.emplace_back();
    event.queue_ = this;
    sift_up({time, order(priority, rank), &event}, heap_.size() - 1);
}

void EventQueue::reschedule(Event& event, Time time, Priority priority) {
    reschedule(event, time, priority, inserted_++);
}

void EventQueue::reschedule(Event& event, Time time, Priority priority, std::uint64_t rank) {
    if (event.scheduled())
        place({time, order(priority, rank), &event}, event.position_);
    else
        schedule(event, time, priority, rank);
}

void EventQueue::cancel(Event& event) {
    if (!event.scheduled())
        return;
    event.queue_ = nullptr;
    remove(event.position_);
}

void EventQueue::happen_next() {
    Event& event = *heap_.front().event;
    ++happened_;
    event.queue_ = nullptr;
    remove(0);
    event.happen();
}

void EventQueue::remove(std::size_t position) {
    Entry last = heap_.back();
    heap_.pop_back();
    if (position < heap_.size())
        place(last, position);
}

/// Puts an entry into a free place of the heap.
inline void EventQueue::place(Entry entry, std::size_t position) {
    if (position > 0 && entry.before(heap_[(position - 1) / children]))
        sift_up(entry, position);
    else
        sift_down(entry, position);
}

void EventQueue::put(Entry entry, std::size_t position) {
    heap_[position] = entry;
    entry.event->position_ = position;
}

// The next functions keep the heap's address and size in local variables, because the compiler cannot know that writes
// to events leave both unchanged.

void EventQueue::sift_up(Entry entry, std::size_t position) {
    Entry* const heap = heap_.data();
    while (position > 0) {
        std::size_t parent = (position - 1) / children;
        if (!entry.before(heap[parent]))
            break;
        heap[position] = heap[parent];
        heap[position].event->position_ = position;
        position = parent;
    }
    put(entry, position);
}

/// Returns the earliest of several siblings. Four siblings are compared in pairs without a branch, because the host
/// processor could not predict it.
inline std::size_t EventQueue::earliest(const Entry* heap, std::size_t first, std::size_t end) {
    static_assert(children == 4);
    if (end - first == children) {
        std::size_t a = first + std::size_t{heap[first + 1].before(heap[first])};
        std::size_t b = first + 2 + std::size_t{heap[first + 3].before(heap[first + 2])};
        return heap[b].before(heap[a]) ? b : a;
    }
    std::size_t found = first;
    for (std::size_t other = first + 1; other < end; ++other)
        found = heap[other].before(heap[found]) ? other : found;
    return found;
}

/// Prefetches the children of all siblings before it is known which sibling is the earliest. Without this, each step
/// down would wait for memory.
inline void EventQueue::fetch_children(const Entry* heap, std::size_t first) {
    constexpr std::size_t line = 64, bytes = children * children * sizeof(Entry);
    const char* begin = reinterpret_cast<const char*>(heap + children * first + 1);
    for (std::size_t at = 0; at <= bytes; at += line)
        __builtin_prefetch(begin + at);
}

void EventQueue::sift_down(Entry entry, std::size_t position) {
    Entry* const heap = heap_.data();
    const std::size_t size = heap_.size();
    const bool in_no_cache = size > events_in_a_cache;
    for (std::size_t child; (child = children * position + 1) < size; position = child) {
        if (in_no_cache) [[unlikely]]
            fetch_children(heap, child);
        child = earliest(heap, child, std::min(child + children, size));
        if (!heap[child].before(entry))
            break;
        heap[position] = heap[child];
        heap[position].event->position_ = position;
    }
    put(entry, position);
}

} // namespace placedpar
