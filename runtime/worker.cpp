#include "runtime/worker.hpp"

#include "runtime/fiber_scheduler.hpp"
#include "runtime/kernel.hpp"

#include <boost/fiber/fiber.hpp>

#include <cstddef>
#include <memory>

namespace placedpar {

namespace {

/// The memory of a stack in the form in which Boost asks for it.
struct InArena {
    std::byte* bottom;

    boost::context::stack_context allocate() const {
        boost::context::stack_context context;
        context.size = Stack::bytes;
        context.sp = bottom + Stack::bytes;
        return context;
    }
    void deallocate(boost::context::stack_context&) const noexcept {}
};

} // namespace

Worker::Worker(Kernel& kernel, const Stack& stack_memory) : memory(stack_memory) {
    using boost::fibers::fiber;
    kernel.scheduler_->expect_worker();
    stack.lies_at(memory.bottom, Stack::bytes);
    fiber(boost::fibers::launch::post, std::allocator_arg, InArena{memory.bottom}, [this, &kernel] {
        work(kernel);
    }).detach();
    context_ = kernel.scheduler_->newest_worker();
}

void Worker::work(Kernel& kernel) {
    stack.arrive_from(*kernel.stack_left_);
    for (;;) {
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
}

} // namespace placedpar
