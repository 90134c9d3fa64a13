// This program runs the four processes of bench/commstime.cpp on the smallest kernel that Boost.Fiber allows: a ready
// queue, a heap of times and a rendezvous. Processes are resumed as in our kernel, but there are no fingerprints,
// reports, owners of channel ends, priorities, ALT and time limits.

#include "least_stackful.hpp"

#include <boost/fiber/algo/algorithm.hpp>
#include <boost/fiber/context.hpp>
#include <boost/fiber/fiber.hpp>
#include <boost/fiber/operations.hpp>

#include <chrono>
#include <cstdlib>
#include <utility>

namespace {

using Context = boost::fibers::context;

void resume(Context& next) { next.resume(); }

LeastKernel<Context, resume> kernel;

/// A scheduling algorithm that makes new fibers ready in the order of their creation.
class Announced final : public boost::fibers::algo::algorithm {
public:
    void awakened(Context* context) noexcept override {
        if (context->is_context(boost::fibers::type::worker_context))
            kernel.make_ready(*context);
        else
            dispatcher_ = context;
    }
    Context* pick_next() noexcept override { return std::exchange(dispatcher_, nullptr); }
    bool has_ready_fibers() const noexcept override { return dispatcher_; }
    void suspend_until(std::chrono::steady_clock::time_point const&) noexcept override {}
    void notify() noexcept override {}

private:
    Context* dispatcher_ = nullptr;
};

} // namespace

int main(int argc, char** argv) {
    long loops = argc > 1 ? std::atol(argv[1]) : 1'000'000;
    boost::fibers::use_scheduling_algorithm<Announced>();
    measure<kernel>("least on Boost.Fiber", loops, argc > 2,
                    [](auto body) { boost::fibers::fiber(boost::fibers::launch::post, body).detach(); });
}
