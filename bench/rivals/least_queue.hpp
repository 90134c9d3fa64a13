#pragma once

#include <deque>
#include <functional>
#include <queue>
#include <vector>

/// What the least kernel needs, whatever its processes run on: who is ready, and who is to be at what time.
template <class Who>
class LeastQueue {
public:
    void make_ready(Who who) { ready_.push_back(who); }
    /// The next one, at whose time it is from now on.
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
    /// Lets so much time pass if nothing else happens meanwhile; returns whether it did.
    bool pass(long time) {
        if (!ready_.empty() || (!future_.empty() && future_.top().time <= now_ + time))
            return false;
        now_ += time;
        return true;
    }
    void delay(long time, Who who) { future_.push({now_ + time, ++delays_, who}); }

private:
    struct Delay {
        long time, number; ///< of one time in the order in which they began, as ours
        Who who;
        bool operator>(const Delay& other) const {
            return time != other.time ? time > other.time : number > other.number;
        }
    };
    std::deque<Who> ready_;
    std::priority_queue<Delay, std::vector<Delay>, std::greater<>> future_;
    long now_ = 0, delays_ = 0;
};
