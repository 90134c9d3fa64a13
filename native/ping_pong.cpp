#include "native/ping_pong.hpp"

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <list>
#include <thread>
#include <utility>
#include <vector>

namespace placedpar::native {

namespace {

using Ball = std::vector<unsigned char>;
using WallClock = std::chrono::steady_clock;

/// The times of batches of equal actions. To read the clock takes about as long as an action.
class Batches {
public:
    explicit Batches(long batch) : batch_(batch) {}

    void begin() {
        if (done_ == 0)
            begun_ = WallClock::now();
    }
    void end() {
        if (++done_ < batch_)
            return;
        const std::chrono::duration<double, std::nano> took = WallClock::now() - begun_;
        nanoseconds_.push_back(took.count() / static_cast<double>(std::exchange(done_, 0)));
    }
    /// Returns the median time of an action; 0 if there was no whole batch.
    double median() {
        if (nanoseconds_.empty())
            return 0;
        const auto middle = nanoseconds_.begin() + std::ssize(nanoseconds_) / 2;
        std::ranges::nth_element(nanoseconds_, middle);
        return *middle;
    }

private:
    long batch_, done_ = 0;
    WallClock::time_point begun_;
    std::vector<double> nanoseconds_;
};

long size_of_batch(long times) { return std::min(times, 50L); }

/// The halves of a channel. If both processes are on one thread, only the first is used.
struct Halves {
    Channel<Ball> output, input;
    explicit Halves(const char* name) : output(name), input(name) {}
    Channel<Ball>& inputters(std::size_t threads) { return threads == 2 ? input : output; }
};

Ball touched(Ball ball) {
    constexpr std::size_t cache_line = 64; // bytes
    for (std::size_t i = 0; i < ball.size(); i += cache_line)
        ++ball[i];
    return ball;
}

class Match {
public:
    explicit Match(const PingPong& match)
        : match_(match), simulations_(match.threads),
          rounds_(match.pause > Time{} || match.bytes > 0 ? 1 : size_of_batch(match.times)) {
        for (Simulation& simulation : simulations_)
            group_.add(simulation);
        if (match.threads == 2) {
            crossings_.emplace_back(there_.output, group_.member(0), there_.input, group_.member(1));
            crossings_.emplace_back(back_.output, group_.member(1), back_.input, group_.member(0));
        }
        simulations_.front().process("ping", [this] { ping(); });
        simulations_.back().process("pong", [this] { pong(); });
    }

    double play() {
        std::vector<std::jthread> running;
        for (Simulation& simulation : simulations_)
            running.emplace_back([&simulation] { simulation.run(); });
        running.clear();
        return rounds_.median();
    }

private:
    void ping() {
        Ball ball(match_.bytes);
        for (long i = 0; i < match_.times; ++i) {
            if (match_.pause > Time{})
                wait_for(match_.pause);
            rounds_.begin();
            there_.output.out().output(touched(std::move(ball)));
            ball = back_.inputters(match_.threads).in().input();
            rounds_.end();
        }
    }
    void pong() {
        for (long i = 0; i < match_.times; ++i)
            back_.output.out().output(touched(there_.inputters(match_.threads).in().input()));
    }

    PingPong match_;
    std::deque<Simulation> simulations_;
    Batches rounds_;
    Group group_;
    Halves there_{"there"}, back_{"back"};
    std::list<Crossing> crossings_;
};

} // namespace

double nanoseconds_there_and_back(const PingPong& match) { return Match(match).play(); }

double nanoseconds_of_switch(long times) {
    Simulation simulation;
    Group group;
    group.add(simulation);
    Batches switches(size_of_batch(times));
    simulation.process("one", [&] {
        for (long i = 0; i < times; ++i) {
            switches.begin();
            wait_until(Time{});
            switches.end();
        }
    });
    simulation.process("other", [times] {
        for (long i = 0; i < times; ++i)
            wait_until(Time{});
    });
    simulation.run();
    return switches.median() / 2; // to the other process and back
}

} // namespace placedpar::native
