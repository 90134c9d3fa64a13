// This program runs COMMSTIME on stackless coroutines of C++20, which need no switch: a waiting process resumes the
// next process. Every function between a process and its channel would have to be a coroutine; here there are no such
// functions.

#include "least_queue.hpp"

#include <coroutine>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

namespace {

LeastQueue<std::coroutine_handle<>> queue;

/// A process that is ready from the beginning, and stays suspended at its end.
struct Process {
    struct promise_type {
        Process get_return_object() {
            queue.make_ready(std::coroutine_handle<promise_type>::from_promise(*this));
            return {};
        }
        std::suspend_always initial_suspend() { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        void return_void() {}
        void unhandled_exception() { std::terminate(); }
    };
};

struct Delay {
    long time;
    bool await_ready() { return queue.pass(time); }
    std::coroutine_handle<> await_suspend(std::coroutine_handle<> self) {
        queue.delay(time, self);
        return queue.take();
    }
    void await_resume() {}
};

/// A synchronous, unbuffered channel from one process to another. The process that arrives second copies the message
/// and continues.
class Rendezvous {
public:
    auto output(long message) { return Output{*this, message}; }
    auto input() { return Input{*this, 0}; }

private:
    struct Output {
        Rendezvous& in;
        long message;
        bool await_ready() {
            if (!in.slot_)
                return false;
            *in.slot_ = message;
            in.slot_ = nullptr;
            queue.make_ready(in.waiting_);
            return true;
        }
        std::coroutine_handle<> await_suspend(std::coroutine_handle<> self) {
            in.message_ = &message;
            in.waiting_ = self;
            return queue.take();
        }
        void await_resume() {}
    };
    struct Input {
        Rendezvous& in;
        long slot;
        bool await_ready() {
            if (!in.message_)
                return false;
            slot = *in.message_;
            in.message_ = nullptr;
            queue.make_ready(in.waiting_);
            return true;
        }
        std::coroutine_handle<> await_suspend(std::coroutine_handle<> self) {
            in.slot_ = &slot;
            in.waiting_ = self;
            return queue.take();
        }
        long await_resume() { return slot; }
    };

    long* message_ = nullptr;
    long* slot_ = nullptr;
    std::coroutine_handle<> waiting_;
};

Rendezvous a, b, c, d;

Process prefix(bool pauses) {
    co_await a.output(0);
    for (;;) {
        long x = co_await b.input();
        if (pauses)
            co_await Delay{1};
        co_await a.output(x);
    }
}

Process delta(bool pauses) {
    for (;;) {
        long x = co_await a.input();
        if (pauses)
            co_await Delay{1};
        co_await c.output(x);
        co_await d.output(x);
    }
}

Process successor(bool pauses) {
    for (;;) {
        long x = co_await c.input();
        if (pauses)
            co_await Delay{1};
        co_await b.output(x + 1);
    }
}

Process consumer(long loops, bool pauses) {
    for (long i = 0; i < loops; ++i) {
        if (co_await d.input() != i)
            std::abort();
        if (pauses)
            co_await Delay{1};
    }
}

} // namespace

int main(int argc, char** argv) {
    long loops = argc > 1 ? std::atol(argv[1]) : 1'000'000;
    bool pauses = argc > 2;
    prefix(pauses), delta(pauses), successor(pauses), consumer(loops, pauses);
    std::clock_t begun = std::clock();
    queue.take().resume();
    double nanoseconds = 1e9 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    std::printf("%-28s %-16s %8.1f ns/loop\n", "least on coroutines", pauses ? "1 ns passing" : "no time passing",
                nanoseconds / static_cast<double>(loops));
}
