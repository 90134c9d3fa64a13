// This program runs the four processes of bench/commstime.cpp on SystemC. The rendezvous uses two events, as a user
// would write it, because SystemC's only blocking channel is buffered.

#include <systemc.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

/// A synchronous, unbuffered channel from one process to another.
class Rendezvous {
public:
    void output(long message) {
        message_ = message;
        full_ = true;
        if (inputter_waits_)
            came_.notify();
        wait(taken_);
    }
    long input() {
        if (!full_) {
            inputter_waits_ = true;
            wait(came_);
            inputter_waits_ = false;
        }
        full_ = false;
        taken_.notify();
        return message_;
    }

private:
    long message_ = 0;
    bool full_ = false, inputter_waits_ = false;
    sc_event came_, taken_;
};

class Commstime : public sc_module {
public:
    SC_HAS_PROCESS(Commstime);
    Commstime(sc_module_name name, long loops, sc_time pause) : sc_module(name), loops_(loops), pause_(pause) {
        SC_THREAD(prefix);
        SC_THREAD(delta);
        SC_THREAD(successor);
        SC_THREAD(consumer);
    }

private:
    void rest() {
        if (pause_ > SC_ZERO_TIME)
            wait(pause_);
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
        sc_stop();
    }

    long loops_;
    sc_time pause_;
    Rendezvous a_, b_, c_, d_;
};

int sc_main(int argc, char** argv) {
    long loops = argc > 1 ? std::atol(argv[1]) : 300'000;
    bool pauses = argc > 2;
    Commstime commstime("commstime", loops, pauses ? sc_time(1, SC_NS) : SC_ZERO_TIME);
    std::clock_t start = std::clock();
    sc_start();
    double nanoseconds = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("SystemC %-24s %8.1f ns/loop\n", pauses ? "1 ns passing" : "no time passing",
                nanoseconds / static_cast<double>(loops));
    return 0;
}
