#include "native/ping_pong.hpp"

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "native/rank_channel.hpp"
#include "native/rank_member.hpp"
#include "ranks/rank_mail.hpp"
#include "ranks/ranks.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <list>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace placedpar::native {

namespace {

using Ball = std::vector<unsigned char>;
using WallClock = std::chrono::steady_clock;

/// Measures equal actions in batches, because reading the clock takes about as long as one action.
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
    /// Returns the median time of an action; 0 if no batch was completed.
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

Ball touched(Ball ball) {
    constexpr std::size_t cache_line = 64; // bytes
    for (std::size_t i = 0; i < ball.size(); i += cache_line)
        ++ball[i];
    return ball;
}

/// The two processes. They also measure the median time of a message there and back.
class Players {
public:
    explicit Players(const PingPong& match)
        : match_(match), rounds_(match.pause > Time{} || match.bytes > 0 ? 1 : size_of_batch(match.times)) {}

    void ping(Channel<Ball>& there, Channel<Ball>& back) {
        Ball ball(match_.bytes);
        for (long i = 0; i < match_.times; ++i) {
            if (match_.pause > Time{})
                wait_for(match_.pause);
            rounds_.begin();
            there.out().output(touched(std::move(ball)));
            ball = back.in().input();
            rounds_.end();
        }
    }
    void pong(Channel<Ball>& there, Channel<Ball>& back) const {
        for (long i = 0; i < match_.times; ++i)
            back.out().output(touched(there.in().input()));
    }
    double median() { return rounds_.median(); }

private:
    PingPong match_;
    Batches rounds_;
};

/// A ping-pong measurement on threads.
class Match {
public:
    explicit Match(const PingPong& match) : players_(match), simulations_(match.kernels) {
        for (Simulation& simulation : simulations_)
            group_.add(simulation);
        if (match.kernels == 2) {
            crossings_.emplace_back(there_.output, group_.member(0), there_.input, group_.member(1));
            crossings_.emplace_back(back_.output, group_.member(1), back_.input, group_.member(0));
        }
        simulations_.front().process("ping", [this] { players_.ping(there_.output, inputters(back_)); });
        simulations_.back().process("pong", [this] { players_.pong(inputters(there_), back_.output); });
    }

    double play() {
        std::vector<std::jthread> running;
        for (Simulation& simulation : simulations_)
            running.emplace_back([&simulation] { simulation.run(); });
        running.clear();
        return players_.median();
    }

private:
    /// A channel between the two processes, with an object for each thread. If both processes are on one thread, only
    /// the object `output` is used.
    struct Halves {
        Channel<Ball> output, input;
        explicit Halves(const char* name) : output(name), input(name) {}
    };
    Channel<Ball>& inputters(Halves& halves) const { return simulations_.size() == 2 ? halves.input : halves.output; }

    Players players_;
    std::deque<Simulation> simulations_;
    Group group_;
    Halves there_{"there"}, back_{"back"};
    std::list<Crossing> crossings_;
};

/// Runs two processes in turn on one thread, and returns the time of a switch between them in nanoseconds.
double run_switches(Simulation& simulation, long times) {
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

/// The text that rank 0 sends to rank 1 after the last measurement.
constexpr const char* no_more = "no more";

std::string text_of(const PingPong& match) { return fmt::format("{} {} {}", match.kernels, match.times, match.bytes); }

PingPong match_of(const std::string& text) {
    PingPong match;
    std::istringstream(text) >> match.kernels >> match.times >> match.bytes;
    return match;
}

/// Executes this rank's part of a measurement.
double play_on_ranks(RankMail& mail, const PingPong& match) {
    Simulation simulation;
    Channel<Ball> there("there"), back("back");
    RankMember member(mail, simulation, 2);
    std::optional<RankGiver> giver;
    std::optional<RankTaker> taker;
    Players players(match);
    const int own = mail.own(), other = 1 - own;
    if (match.kernels == 2) {
        giver.emplace(member, own == 0 ? there : back, static_cast<std::size_t>(own), other);
        taker.emplace(member, own == 0 ? back : there, static_cast<std::size_t>(other), other);
    }
    if (own == 0)
        simulation.process("ping", [&] { players.ping(there, back); });
    if (own + 1 == static_cast<int>(match.kernels))
        simulation.process("pong", [&] { players.pong(there, back); });
    member.begin();
    simulation.run();
    return players.median();
}

} // namespace

double nanoseconds_there_and_back(const PingPong& match) { return Match(match).play(); }

double nanoseconds_of_switch(long times) {
    Simulation simulation;
    Group group;
    group.add(simulation);
    return run_switches(simulation, times);
}

RankMatches::RankMatches(Ranks& ranks) : ranks_(ranks), mail_(ranks.open_mail()) {}

RankMatches::~RankMatches() { ranks_.send(1, no_more); }

/// Begins a measurement. Waits until rank 1 has finished the previous measurement, which could otherwise take letters
/// of the new one.
void RankMatches::announce(const PingPong& match) {
    ranks_.send(1, text_of(match));
    wait_for_message(ranks_);
}

double RankMatches::nanoseconds_there_and_back(const PingPong& match) {
    announce(match);
    return play_on_ranks(*mail_, match);
}

double RankMatches::nanoseconds_of_switch(long times) {
    announce({.kernels = 1});
    Simulation simulation;
    RankMember member(*mail_, simulation, 0);
    member.begin();
    return run_switches(simulation, times);
}

void play_with_rank_zero(Ranks& ranks) {
    const std::unique_ptr<RankMail> mail = ranks.open_mail();
    for (;;) {
        const std::string text = wait_for_message(ranks).text;
        if (text == no_more)
            return;
        ranks.send(0, "ready");
        play_on_ranks(*mail, match_of(text));
    }
}

double nanoseconds_of_oversleeping() {
    constexpr Time pause = pause_after(Time{});
    Batches pauses(1);
    for (int i = 0; i < 50; ++i) {
        pauses.begin();
        std::this_thread::sleep_for(std::chrono::duration_cast<std::chrono::nanoseconds>(pause));
        pauses.end();
    }
    return std::max(pauses.median() - std::chrono::duration<double, std::nano>(pause).count(), 0.0);
}

} // namespace placedpar::native
