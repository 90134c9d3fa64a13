// This program runs the four processes of bench/commstime.cpp as actors of SimGrid. The rendezvous uses two semaphores,
// because SimGrid's mailboxes take the time that the network's model states.

#include <simgrid/s4u.hpp>

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace sg4 = simgrid::s4u;

/// A synchronous, unbuffered channel from one actor to another.
class Rendezvous {
public:
    void output(long message) {
        message_ = message;
        came_->release();
        taken_->acquire();
    }
    long input() {
        came_->acquire();
        long message = message_;
        taken_->release();
        return message;
    }

private:
    long message_ = 0;
    sg4::SemaphorePtr came_ = sg4::Semaphore::create(0), taken_ = sg4::Semaphore::create(0);
};

class Commstime {
public:
    Commstime(sg4::Host* host, long loops, bool pauses) : loops_(loops), pauses_(pauses) {
        sg4::Actor::create("prefix", host, [this] { prefix(); })->daemonize();
        sg4::Actor::create("delta", host, [this] { delta(); })->daemonize();
        sg4::Actor::create("successor", host, [this] { successor(); })->daemonize();
        sg4::Actor::create("consumer", host, [this] { consumer(); });
    }

private:
    void rest() const {
        if (pauses_)
            sg4::this_actor::sleep_for(1);
    }
    void prefix() {
        a_.output(0);
        for (;;) {
            long x = b_.input();
            rest();
            a_.output(x);
        }
    }
    void delta() {
        for (;;) {
            long x = a_.input();
            rest();
            c_.output(x);
            d_.output(x);
        }
    }
    void successor() {
        for (;;) {
            long x = c_.input();
            rest();
            b_.output(x + 1);
        }
    }
    void consumer() {
        for (long i = 0; i < loops_; ++i) {
            if (d_.input() != i)
                std::abort();
            rest();
        }
    }

    long loops_;
    bool pauses_;
    Rendezvous a_, b_, c_, d_;
};

int main(int argc, char** argv) {
    sg4::Engine engine(&argc, argv);
    sg4::NetZone* zone = sg4::create_full_zone("zone");
    sg4::Host* host = zone->create_host("host", 1e9);
    zone->seal();
    long loops = argc > 1 ? std::atol(argv[1]) : 100'000;
    bool pauses = argc > 2;
    Commstime commstime(host, loops, pauses);
    std::clock_t start = std::clock();
    engine.run();
    double nanoseconds = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("SimGrid %-25s %8.1f ns/loop\n", pauses ? "1 s passing" : "no time passing",
                nanoseconds / static_cast<double>(loops));
}
