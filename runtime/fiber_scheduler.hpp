#pragma once

#include <boost/fiber/algo/algorithm.hpp>
#include <boost/fiber/context.hpp>

#include <chrono>
#include <deque>
#include <utility>

namespace placedpar {

/// The scheduling algorithm that Boost.Fiber requires. In fact the kernel decides which process runs, and resumes the
/// process's fiber itself. This class only hands new fibers to the kernel. Fibers that existed before the run (Boost's
/// dispatcher and the calling program's fibers) are not resumed until the run is over. Boost's clocks are never used.
class FiberScheduler final : public boost::fibers::algo::algorithm {
public:
    using Context = boost::fibers::context;

    /// `host`: the fiber that called Kernel::run. `self`: set to point to the algorithm, which Boost owns.
    FiberScheduler(Context* host, FiberScheduler*& self) : host_(host) { self = this; }

    Context* host() const { return host_; }

    /// States that the next fiber that Boost announces belongs to a new worker. A worker is a fiber on which processes
    /// run.
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
