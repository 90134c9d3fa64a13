#pragma once

#include <deque>
#include <functional>
#include <queue>
#include <vector>

/// The scheduler of the smallest kernel: a queue of ready processes, and a heap of processes that wait for a time.
/// `Who` identifies a process.
template <class Who>
class LeastQueue {
public:
    void make_ready(Who who) { ready_.push_back(who); }
    /// Returns the next ready process. If there is none, returns the first waiting process and advances the time.
    Who take() {
        if (ready_.empty()) {
            Delay next = future_.top();
            future_.pop();
            now_ = next.time;
            return next.who;
        }
        Who next = ready_.front();
        ready_.pop_front();
        return next;
    }
    /// Lets `time` pass if nothing else happens before its end. Returns whether the time has passed.
    bool pass(long time) {
        if (!ready_.empty() || (!future_.empty() && future_.top().time <= now_ + time))
            return false;
        now_ += time;
        return true;
    }
    void delay(long time, Who who) { future_.push({now_ + time, ++delays_, who}); }

private:
    struct Delay {
        long time, number; ///< delays that end at the same time are ordered by `number`, the order of their starts, as
                           ///< in our kernel
        Who who;
        bool operator>(const Delay& other) const {
            return time != other.time ? time > other.time : number > other.number;
        }
    };
    std::deque<Who> ready_;
    std::priority_queue<Delay, std::vector<Delay>, std::greater<>> future_;
    long now_ = 0, delays_ = 0;
};
