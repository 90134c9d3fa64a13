#pragma once

#include "least_queue.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>

/// The smallest kernel for processes with stacks. `switch_to` continues the process of a context.
template <class Context, void (*switch_to)(Context&)>
class LeastKernel {
public:
    void make_ready(Context& context) { queue_.make_ready(&context); }
    void wait() {
        Context* next = queue_.take();
        if (next != running_)
            go_to(*next);
    }
    void wait_for(long time) {
        if (queue_.pass(time))
            return;
        queue_.delay(time, running_);
        wait();
    }
    void go_to(Context& next) {
        running_ = &next;
        switch_to(next);
    }
    Context& running() const { return *running_; }

private:
    LeastQueue<Context*> queue_;
    Context* running_ = nullptr;
};

/// A synchronous, unbuffered channel from one process to another. The process that arrives second copies the message
/// and continues.
template <auto& kernel>
class Rendezvous {
public:
    void output(long message) {
        if (slot_) {
            *slot_ = message;
            slot_ = nullptr;
            kernel.make_ready(*waiting_);
        } else {
            message_ = &message;
            wait();
        }
    }
    long input() {
        long slot;
        if (message_) {
            slot = *message_;
            message_ = nullptr;
            kernel.make_ready(*waiting_);
        } else {
            slot_ = &slot;
            wait();
        }
        return slot;
    }

private:
    void wait() {
        waiting_ = &kernel.running();
        kernel.wait();
    }
    long* message_ = nullptr;
    long* slot_ = nullptr;
    decltype(&kernel.running()) waiting_ = nullptr;
};

/// Runs the network for `loops` loops, and ends the program. `start(body)` makes a process.
template <auto& kernel, class Start>
[[noreturn]] void measure(const char* name, long loops, bool pauses, Start start) {
    Rendezvous<kernel> a, b, c, d;
    auto rest = [pauses] {
        if (pauses)
            kernel.wait_for(1);
    };
    std::clock_t begun;
    start([&] {
        a.output(0);
        for (;;) {
            long x = b.input();
            rest();
            a.output(x);
        }
    });
    start([&] {
        for (;;) {
            long x = a.input();
            rest();
            c.output(x);
            d.output(x);
        }
    });
    start([&] {
        for (;;) {
            long x = c.input();
            rest();
            b.output(x + 1);
        }
    });
    start([&] {
        for (long i = 0; i < loops; ++i) {
            if (d.input() != i)
                std::abort();
            rest();
        }
        double nanoseconds = 1e9 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
        std::printf("%-28s %-16s %8.1f ns/loop\n", name, pauses ? "1 ns passing" : "no time passing",
                    nanoseconds / static_cast<double>(loops));
        std::fflush(stdout);
        std::_Exit(0); // the other processes never end
    });
    begun = std::clock();
    kernel.wait();
    std::abort();
}
