#include "runtime/worker.hpp"

#include "runtime/fiber_scheduler.hpp"
#include "runtime/kernel.hpp"

#include <boost/fiber/fiber.hpp>
#include <boost/fiber/fixedsize_stack.hpp>
#include <boost/fiber/protected_fixedsize_stack.hpp>

#include <functional>

namespace placedpar {

namespace {

/// Only the pages that a process touches take memory. AddressSanitizer's red zones make stack frames several times
/// larger.
constexpr std::size_t stack_bytes = (SwitchedStack::watched ? 1024 : 256) * 1024;

/// Boost's allocator of stacks, which also notes where the stack lies.
template <class Allocator>
struct Noting {
    Allocator allocator{stack_bytes};
    SwitchedStack* stack;

    boost::context::stack_context allocate() {
        auto context = allocator.allocate();
        stack->lies_at(static_cast<char*>(context.sp) - context.size, context.size);
        return context;
    }
    void deallocate(boost::context::stack_context& context) noexcept { allocator.deallocate(context); }
};

template <class Allocator>
void launch(SwitchedStack& stack, std::function<void()> work) {
    using boost::fibers::fiber;
    fiber(boost::fibers::launch::post, std::allocator_arg, Noting<Allocator>{.stack = &stack}, std::move(work))
        .detach();
}

} // namespace

Worker::Worker(Kernel& kernel, bool guarded) {
    kernel.scheduler_->expect_worker();
    auto body = [this, &kernel] { work(kernel); };
    if (guarded && !SwitchedStack::watched)
        launch<boost::fibers::protected_fixedsize_stack>(stack, body);
    else
        launch<boost::fibers::fixedsize_stack>(stack, body);
    context_ = kernel.scheduler_->newest_worker();
}

void Worker::work(Kernel& kernel) {
    stack.arrive_from(*kernel.stack_left_);
    while (!dismissed) {
        Process& self = *process;
        try {
            self.body_();
        } catch (const Unwinding&) {
        } catch (...) {
            kernel.fail(self);
        }
        process = nullptr;
        kernel.finish(self);
        Process* next = kernel.unwinding_ ? nullptr : kernel.next_with_worker();
        if (next && next->worker_ == this)
            kernel.running_ = next;
        else
            kernel.switch_to(next);
    }
    stack.end_for(kernel.host_stack_);
}

} // namespace placedpar
