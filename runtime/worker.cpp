#include "runtime/worker.hpp"

#include "runtime/fiber_scheduler.hpp"
#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

#include <boost/fiber/fiber.hpp>

#include <cstddef>
#include <memory>
#include <new>

namespace placedpar {

namespace {

/// The size of a worker at the top of its stack, in bytes. It is rounded up to whole cache lines.
constexpr std::size_t bytes_of_worker = (sizeof(Worker) + 63) / 64 * 64;

/// Gives Boost the part of a stack below its worker.
struct InArena {
    std::byte* bottom;

    boost::context::stack_context allocate() const {
        boost::context::stack_context context;
        context.size = Stack::bytes() - bytes_of_worker;
        context.sp = bottom + context.size;
        return context;
    }
    void deallocate(boost::context::stack_context&) const noexcept {}
};

} // namespace

void EndWorker::operator()(Worker* worker) const {
    worker->stack.gone();
    worker->~Worker();
}

std::unique_ptr<Worker, EndWorker> Worker::make(Kernel& kernel, const Stack& stack) {
    return std::unique_ptr<Worker, EndWorker>(new (stack.bottom + Stack::bytes() - bytes_of_worker)
                                                  Worker(kernel, stack));
}

Worker::Worker(Kernel& kernel, const Stack& stack_memory) : memory(stack_memory) {
    using boost::fibers::fiber;
    kernel.fibers_.scheduler->expect_worker();
    stack.lies_at(memory.bottom, Stack::bytes());
    fiber(boost::fibers::launch::post, std::allocator_arg, InArena{memory.bottom}, [this, &kernel] {
        work(kernel);
    }).detach();
    context_ = kernel.fibers_.scheduler->newest_worker();
}

// A process that continues first reads its saved registers, which are at the end of its stack, and the youngest frames
// above them. Without the prefetch it would wait for each cache line.
void Worker::fetch_stack(Process* leaves, const Process& next) {
    constexpr std::ptrdiff_t line = 64, lines_below = 2, lines_above = 8;
    if (leaves)
        leaves->stack_ends_ = static_cast<const std::byte*>(__builtin_frame_address(0));
    __builtin_prefetch(next.worker_);
    if (next.stack_ends_)
        for (std::ptrdiff_t i = -lines_below; i < lines_above; ++i)
            __builtin_prefetch(next.stack_ends_ + i * line);
}

void Worker::work(Kernel& kernel) {
    stack.arrive_from(*kernel.fibers_.stack_left);
    for (;;) {
        Process& self = *process;
        try {
            self.body_();
            if (ReplayLog* history = self.history())
                history->end();
        } catch (const Unwinding&) {
        } catch (...) {
            kernel.fail(self);
        }
        process = nullptr;
        kernel.finish(self);
        Process* next =
            kernel.hot_.rare_conditions.any_of(RareConditions::unwinding) ? nullptr : kernel.next_with_worker();
        if (next && next->worker_ == this)
            kernel.hot_.running = next;
        else
            kernel.switch_to(next);
    }
}

} // namespace placedpar
