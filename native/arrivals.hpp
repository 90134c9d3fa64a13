#pragma once

#include <atomic>
#include <utility>

namespace placedpar::native {

/// A message to a kernel of a native run, that is, to one of the threads that run processes. A message is in at most
/// one inbox at a time, and holds the link of the inbox's list, so that posting needs no memory.
class Arrival {
public:
    Arrival() = default;
    Arrival(const Arrival&) = delete;
    Arrival& operator=(const Arrival&) = delete;

protected:
    ~Arrival() = default;

private:
    friend class Inbox;
    /// Called by the thread that receives the message, between two turns of its processes.
    virtual void arrive() noexcept = 0;

    Arrival* next_ = nullptr;
};

/// The messages that wait for a kernel. Any thread may post a message; the kernel's thread takes the messages in the
/// order of posting.
class Inbox {
public:
    bool empty() const { return newest_.load() == nullptr; }
    /// REQUIRES: the message is in no inbox.
    void post(Arrival& arrival) {
        arrival.next_ = newest_.load(std::memory_order_relaxed);
        while (!newest_.compare_exchange_weak(arrival.next_, &arrival)) {
        }
    }
    /// Calls arrive() for each message that was posted before this call.
    void take() noexcept {
        if (empty())
            return;
        for (Arrival* each = oldest_first(newest_.exchange(nullptr)); each;) {
            Arrival* const next = each->next_; // read first: an arrival may be posted again while it is handled
            each->arrive();
            each = next;
        }
    }

private:
    /// Reverses the order of the messages, and returns the oldest message.
    static Arrival* oldest_first(Arrival* newest) {
        Arrival* oldest = nullptr;
        while (newest) {
            Arrival* const older = std::exchange(newest->next_, oldest);
            oldest = std::exchange(newest, older);
        }
        return oldest;
    }

    std::atomic<Arrival*> newest_{nullptr};
};

} // namespace placedpar::native
