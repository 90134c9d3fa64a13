#pragma once

#include <boost/fiber/algo/algorithm.hpp>
#include <boost/fiber/context.hpp>

#include <chrono>
#include <deque>
#include <utility>

namespace placedpar {

/// Boost.Fiber's view of a running simulation. The kernel decides which process runs and resumes its fiber itself; this
/// algorithm only takes delivery of the fibers that Boost announces: new ones, which it hands to the kernel, and those
/// that were there before (Boost's dispatcher, the host program's own fibers), which rest until the run is over.
/// Boost's own clocks are never used.
class FiberScheduler final : public boost::fibers::algo::algorithm {
public:
    using Context = boost::fibers::context;

    /// `host` is the fiber that called Kernel::run. Boost owns the algorithm; `self` is set to point to it.
    FiberScheduler(Context* host, FiberScheduler*& self) : host_(host) { self = this; }

    Context* host() const { return host_; }

    /// Tells the scheduler that the next fiber that Boost announces belongs to a new worker.
    void expect_worker() { newest_ = nullptr, expecting_worker_ = true; }
    Context* newest_worker() const { return newest_; }

    void awakened(Context* context) noexcept override {
        if (std::exchange(expecting_worker_, false))
            newest_ = context;
        else
            resting_.push_back(context);
    }

    Context* pick_next() noexcept override {
        if (resting_.empty())
            return nullptr;
        Context* next = resting_.front();
        resting_.pop_front();
        return next;
    }

    bool has_ready_fibers() const noexcept override { return !resting_.empty(); }
    void suspend_until(std::chrono::steady_clock::time_point const&) noexcept override {}
    void notify() noexcept override {}

private:
    Context* host_;
    Context* newest_ = nullptr;
    std::deque<Context*> resting_; ///< fibers that are not workers
    bool expecting_worker_ = false;
};

} // namespace placedpar
