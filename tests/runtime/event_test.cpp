// Tests that the event queue gives its events in the order stated in kernel.hpp, also after cancellations.

#include "runtime/event.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

using namespace placedpar;

namespace {

struct Noted final : Event {
    Noted(std::vector<std::size_t>& list, std::size_t n) : happened(list), number(n) {}
    void happen() noexcept override { happened.push_back(number); }
    std::vector<std::size_t>& happened;
    std::size_t number;
};

/// A queue, with an ordered set of the events expected from it.
class Pair {
public:
    explicit Pair(std::size_t events) : keys_(events) {
        for (std::size_t n = 0; n < events; ++n)
            events_.push_back(std::make_unique<Noted>(happened_, n));
    }
    bool scheduled(std::size_t n) const { return events_[n]->scheduled(); }
    /// Schedules event n. With a priority below `turn`, the event also has a rank, which is n.
    void schedule(std::size_t n, Time time, EventQueue::Priority priority) {
        bool again = scheduled(n);
        forget(n);
        bool ranked = priority < EventQueue::turn;
        if (ranked && again)
            queue_.reschedule(*events_[n], time, priority, n);
        else if (ranked)
            queue_.schedule(*events_[n], time, priority, n);
        else if (again)
            queue_.reschedule(*events_[n], time, priority);
        else
            queue_.schedule(*events_[n], time, priority);
        keys_[n] = Key{time, priority, ranked ? n : inserted_++, n};
        expected_.insert(*keys_[n]);
        CHECK(queue_.time_of(*events_[n]) == time);
    }
    void cancel(std::size_t n) {
        queue_.cancel(*events_[n]);
        forget(n);
    }
    void destroy(std::size_t n) {
        events_[n] = std::make_unique<Noted>(happened_, n);
        forget(n);
    }
    void happen_next() {
        REQUIRE(queue_.empty() == expected_.empty());
        if (expected_.empty())
            return;
        Key key = *expected_.begin();
        REQUIRE(queue_.next_time() == std::get<Time>(key));
        queue_.happen_next();
        REQUIRE(happened_.back() == std::get<3>(key));
        CHECK_FALSE(scheduled(happened_.back()));
        forget(happened_.back());
    }
    std::size_t left() const { return expected_.size(); }

private:
    using Key = std::tuple<Time, EventQueue::Priority, std::uint64_t, std::size_t>;
    void forget(std::size_t n) {
        if (keys_[n])
            expected_.erase(*keys_[n]);
        keys_[n].reset();
    }

    std::vector<std::size_t> happened_;
    EventQueue queue_;
    std::vector<std::unique_ptr<Noted>> events_;
    std::vector<std::optional<Key>> keys_;
    std::set<Key> expected_;
    std::uint64_t inserted_ = 0;
};

} // namespace

TEST_CASE("events happen by time, priority, and rank or insertion, also after changes of the queue") {
    for (std::uint32_t events : {1u, 2u, 5u, 30u, 400u}) {
        RandomStream random(events, "future");
        Pair both(events);
        Time now{};
        for (int step = 0; step < 20'000; ++step) {
            std::size_t n = random.below(events);
            switch (random.below(8)) {
            case 0: both.cancel(n); break;
            case 1: both.destroy(n); break;
            case 2:
            case 3: both.happen_next(); break;
            default: // many events at one time, also at the last possible one
                both.schedule(n, random.below(50) == 0 ? Time::max() : now + Time{random.below(20)},
                              static_cast<EventQueue::Priority>(random.below(5)));
            }
            now += Time{random.below(3) == 0};
        }
        while (both.left() > 0)
            both.happen_next();
        both.happen_next();
    }
}

TEST_CASE("events that outlive their queue are not scheduled any more") {
    std::vector<std::size_t> happened;
    Noted noted(happened, 0);
    {
        EventQueue queue;
        queue.schedule(noted, Time{1}, EventQueue::timer);
        CHECK(noted.scheduled());
    }
    CHECK_FALSE(noted.scheduled());
    CHECK(happened.empty());
}
