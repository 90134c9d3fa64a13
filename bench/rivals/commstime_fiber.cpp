// The four processes of bench/commstime.cpp on the least kernel that Boost.Fiber allows: a ready queue, a heap of times
// and a rendezvous, resumed as ours are, but without fingerprint, reports, owners of ends, priorities, ALT and time
// limits.

#include <boost/fiber/algo/algorithm.hpp>
#include <boost/fiber/context.hpp>
#include <boost/fiber/fiber.hpp>
#include <boost/fiber/operations.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

using Context = boost::fibers::context;

/// Who is ready, and who is to be at what time.
class Kernel {
public:
    void make_ready(Context* context) { ready_.push_back(context); }
    void wait() {
        Context* next;
        if (ready_.empty()) {
            now_ = future_.top().time;
            next = future_.top().context;
            future_.pop();
        } else {
            next = ready_.front();
            ready_.pop_front();
        }
        if (next != running_)
            switch_to(next);
    }
    void wait_for(long time) {
        long due = now_ + time;
        if (ready_.empty() && (future_.empty() || future_.top().time > due)) {
            now_ = due;
            return;
        }
        future_.push({due, ++delays_, running_});
        wait();
    }
    void switch_to(Context* next) {
        running_ = next;
        next->resume();
    }
    Context* running() const { return running_; }

private:
    struct Delay {
        long time, number; ///< of one time in the order in which they began, as ours
        Context* context;
        bool operator>(const Delay& other) const {
            return time != other.time ? time > other.time : number > other.number;
        }
    };
    std::deque<Context*> ready_;
    std::priority_queue<Delay, std::vector<Delay>, std::greater<>> future_;
    long now_ = 0, delays_ = 0;
    Context* running_ = nullptr;
};

Kernel kernel;

/// New fibers are ready in the order of their creation.
class Announced final : public boost::fibers::algo::algorithm {
public:
    void awakened(Context* context) noexcept override {
        if (context->is_context(boost::fibers::type::worker_context))
            kernel.make_ready(context);
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

/// Synchronous and unbuffered, from one process to one other. Who comes second copies and goes on.
class Rendezvous {
public:
    void output(long message) {
        if (slot_) {
            *slot_ = message;
            slot_ = nullptr;
            kernel.make_ready(waiting_);
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
            kernel.make_ready(waiting_);
        } else {
            slot_ = &slot;
            wait();
        }
        return slot;
    }

private:
    void wait() {
        waiting_ = kernel.running();
        kernel.wait();
    }
    long* message_ = nullptr;
    long* slot_ = nullptr;
    Context* waiting_ = nullptr;
};

int main(int argc, char** argv) {
    long loops = argc > 1 ? std::atol(argv[1]) : 1'000'000;
    bool pauses = argc > 2;
    boost::fibers::use_scheduling_algorithm<Announced>();
    Context* host = Context::active();
    Rendezvous a, b, c, d;
    auto rest = [pauses] {
        if (pauses)
            kernel.wait_for(1);
    };
    auto start = [](auto body) { boost::fibers::fiber(boost::fibers::launch::post, body).detach(); };
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
        kernel.switch_to(host);
    });
    std::clock_t begun = std::clock();
    kernel.wait();
    double nanoseconds = 1e9 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    std::printf("least on Boost.Fiber %-24s %8.1f ns/loop\n", pauses ? "1 ns passing" : "no time passing",
                nanoseconds / static_cast<double>(loops));
    std::fflush(stdout);
    std::_Exit(0); // the fibers never end
}
