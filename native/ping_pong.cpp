#include "native/ping_pong.hpp"

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <chrono>
#include <deque>
#include <list>
#include <thread>
#include <utility>
#include <vector>

namespace placedpar::native {

namespace {

using Ball = std::vector<unsigned char>;
using WallClock = std::chrono::steady_clock;

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
    explicit Match(const PingPong& match) : match_(match), simulations_(match.threads) {
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
        return std::chrono::duration<double, std::nano>(played_).count() / static_cast<double>(match_.times);
    }

private:
    void ping() {
        Ball ball(match_.bytes);
        for (long i = 0; i < match_.times; ++i) {
            if (match_.pause > Time{})
                wait_for(match_.pause);
            const auto begun = WallClock::now();
            there_.output.out().output(touched(std::move(ball)));
            ball = back_.inputters(match_.threads).in().input();
            played_ += WallClock::now() - begun;
        }
    }
    void pong() {
        for (long i = 0; i < match_.times; ++i)
            back_.output.out().output(touched(there_.inputters(match_.threads).in().input()));
    }

    PingPong match_;
    std::deque<Simulation> simulations_;
    Group group_;
    Halves there_{"there"}, back_{"back"};
    std::list<Crossing> crossings_;
    WallClock::duration played_{};
};

} // namespace

double nanoseconds_there_and_back(const PingPong& match) { return Match(match).play(); }

double nanoseconds_of_switch(long times) {
    Simulation simulation;
    Group group;
    group.add(simulation);
    const auto give_way = [times] {
        for (long i = 0; i < times; ++i)
            wait_until(Time{});
    };
    simulation.process("one", give_way);
    simulation.process("other", give_way);
    const auto begun = WallClock::now();
    simulation.run();
    return std::chrono::duration<double, std::nano>(WallClock::now() - begun).count() / static_cast<double>(2 * times);
}

} // namespace placedpar::native
