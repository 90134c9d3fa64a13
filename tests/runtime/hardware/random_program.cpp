#include "random_program.hpp"

#include "runtime/alternation.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"

#include <array>
#include <cstddef>

namespace placedpar::test {

RandomProgram::RandomProgram(RandomStream random, const RandomPace& pace, int rounds, MachineLog& log)
    : random_(random), pace_(pace), rounds_(rounds), log_(log),
      longest_letter_(std::array{1u, 3u, 40u, 300u, 300u}[random_.below(5)]),
      patience_(std::array{10u, 30u, 200u, 1'000u, 4'000u}[random_.below(5)]),
      pauses_(std::array{0.0, 0.2, 0.6}[random_.below(3)]), gives_up_(random_.chance(0.7) ? 1 : 0.5) {}

void RandomProgram::send(Lane& lane) {
    double gives_up = lane.can_be_given_up ? gives_up_ : 0;
    for (int number = 0; number < rounds_; ++number) {
        pause();
        if (random_.chance(gives_up)) {
            send_or_give_up(lane, letter(number));
        } else {
            lane.channel.out().output(letter(number));
            lane.gone.push_back(number);
            note("has sent", lane, static_cast<std::uint64_t>(number));
        }
        if (random_.chance(gives_up / 20))
            note("has reset output", lane, reset(lane.channel.out()));
    }
}

void RandomProgram::send_or_give_up(Lane& lane, const Letter& letter) {
    auto out = lane.channel.out();
    bool by_time = !lane.failures_are_told || random_.chance(0.5);
    bool gone =
        by_time ? output_or_fail(out, letter, middle_of(letter)) : output_or_fail(out, letter, lane.output_fails.in());
    if (gone) {
        lane.gone.push_back(letter.number);
        return note("has sent in time", lane, static_cast<std::uint64_t>(letter.number));
    }
    pause();
    note("has given up output", lane, reset(out));
}

void RandomProgram::receive(const std::vector<Lane*>& lanes) {
    for (int round = 0; round < rounds_; ++round) {
        pause();
        Lane& lane = *lanes[random_.below(static_cast<std::uint32_t>(lanes.size()))];
        if (random_.chance(lanes.size() > 1 ? 0.8 : 0.25))
            alternate(lanes);
        else
            receive_from(lane, random_.chance(gives_up_));
        if (lane.can_be_given_up && random_.chance(0.03))
            note("has reset input", lane, reset(lane.channel.in()));
    }
}

/// Alternates between the lanes. The program may then leave the message without an input.
void RandomProgram::alternate(const std::vector<Lane*>& lanes) {
    std::vector<Guard> guards;
    for (Lane* lane : lanes)
        guards.push_back({Guard::input, &lane->channel});
    guards.push_back({Guard::timeout, nullptr, soon()});
    std::size_t chosen = select(guards);
    if (chosen == lanes.size())
        return note("has chosen the time-out beside", *lanes.front(), 0);
    note("has chosen", *lanes[chosen], 0);
    if (random_.chance(0.85))
        receive_from(*lanes[chosen], random_.chance(gives_up_));
}

void RandomProgram::receive_from(Lane& lane, bool may_be_given_up) {
    if (may_be_given_up && lane.can_be_given_up)
        return receive_or_give_up(lane);
    lane.came.push_back(lane.channel.in().input().number);
    note("has received", lane, static_cast<std::uint64_t>(lane.came.back()));
}

void RandomProgram::receive_or_give_up(Lane& lane) {
    auto in = lane.channel.in();
    Letter letter;
    bool by_time = !lane.failures_are_told || random_.chance(0.5);
    bool came = by_time ? input_or_fail(in, letter, soon()) : input_or_fail(in, letter, lane.input_fails.in());
    if (came) {
        lane.came.push_back(letter.number);
        return note("has received in time", lane, static_cast<std::uint64_t>(letter.number));
    }
    pause();
    note("has given up input", lane, reset(in));
}

void RandomProgram::repeat(std::uint32_t bits, const std::function<void(RandomStream&)>& act) {
    for (int round = 0; round < rounds_; ++round) {
        wait_for(pace_.bits(1) + pace_.less_than(bits, random_));
        act(random_);
    }
}

Letter RandomProgram::letter(int number) {
    Letter letter{.number = number, .body = 1 + random_.below(longest_letter_)};
    if (random_.chance(0.5))
        letter.head = 1 + random_.below(2);
    if (random_.chance(0.2))
        letter.tail = 1 + random_.below(3);
    return letter;
}

void RandomProgram::pause() {
    if (random_.chance(pauses_))
        wait_for(pace_.pause(random_));
}

/// Returns a time in the middle of the letter, or a time that comes soon.
Time RandomProgram::middle_of(const Letter& letter) {
    if (random_.chance(0.3))
        return soon();
    return now() + pace_.less_than(20 + 15 * (letter.head + letter.body + letter.tail), random_);
}

/// Returns a time that comes soon, so that both ends, or both directions, often give up almost together.
Time RandomProgram::soon() {
    if (random_.chance(0.5))
        return now() + pace_.less_than(patience_, random_);
    return now() + pace_.bits(patience_) + pace_.less_than(15, random_);
}

void RandomProgram::note(const std::string& what, const Lane& lane, std::uint64_t value) {
    log_.note(now(), what + " on " + lane.channel.name(), static_cast<std::int64_t>(value));
}

} // namespace placedpar::test
