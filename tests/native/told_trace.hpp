#pragma once

#include "native/native_trace.hpp"
#include "runtime/channel.hpp"
#include "runtime/trace.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::test {

/// The outputter and the inputter of each message of each channel, in order.
using PassedMessages = std::map<std::string, std::vector<std::pair<std::string, std::string>>>;

/// Notes the messages of a simulated run.
struct SimulatedMessages final : TraceSink {
    void turns(const Process&, Activity, Time) override {}
    void communicated(const AnyChannel& channel, Time) override {
        passed[channel.name()].emplace_back(channel.outputter()->path(), channel.inputter()->path());
    }
    void takes(const PlaceTaken&, Time) override {}
    void leaves(const PlaceLeft&, Time) override {}
    void over(Time) override {}

    PassedMessages passed;
};

/// Notes what a native run reports to its trace.
struct ToldTrace final : TraceSink {
    struct End {
        std::string process;
        Time begun = Time::max(), ended = Time::max(); ///< of the output or the input
    };
    struct Message {
        std::string channel;
        End output, input;
    };
    struct Doing {
        std::string place;
        Activity activity;
        Time since;
        std::vector<Time*> ends = {}; ///< set when the wait ends
    };

    void turns(const Process&, Activity, Time) override { FAIL("the processes do not exist any more"); }
    void communicated(const AnyChannel&, Time) override { FAIL("the channels do not exist any more"); }
    void takes(const PlaceTaken&, Time) override {}
    void leaves(const PlaceLeft&, Time) override {}
    void program_turns(const ProgramTurn& turn, Time now) override {
        come(now);
        Doing& doing = lanes[turn.process];
        for (Time* end : doing.ends)
            *end = now;
        doing = {turn.place, turn.activity, now};
        is_computing[turn.place] += turn.activity == Activity::computing;
        ++turns_told;
    }
    void program_communicates(const MessagePart& part, Time now) override {
        come(now);
        Message& message = messages[part.message];
        message.channel = part.channel;
        End& end = part.is_input ? message.input : message.output;
        Doing& doing = lanes[part.process];
        end = {part.process, now, now};
        if (!is_waiting(doing.activity))
            return;
        end.begun = doing.since;
        end.ended = Time::max();
        doing.ends.push_back(&end.ended);
    }
    void over(Time now) override {
        come(now);
        end = now;
    }
    void ends_early(Time now, const std::string& reason) override {
        come(now);
        end = now;
        why = reason;
    }

    void come(Time now) {
        CHECK(now >= last);
        last = now;
    }
    PassedMessages passed() const {
        PassedMessages all;
        for (const auto& [number, message] : messages)
            all[message.channel].emplace_back(message.output.process, message.input.process);
        return all;
    }
    /// Checks that no input ends before its output has begun, by clocks that differ by at most `error`.
    void check_causes(Time error) const {
        for (const auto& [number, message] : messages)
            CHECK(message.output.begun <= later(message.input.ended, error));
    }
    /// Checks that no output ends before its input has begun.
    void check_channels_are_synchronous() const {
        for (const auto& [number, message] : messages)
            CHECK(message.input.begun <= message.output.ended);
    }

    std::map<std::string, Doing> lanes;
    std::map<std::uint64_t, Message> messages; ///< the messages of each channel are in order
    std::map<std::string, int> is_computing;   ///< for each place, the number of computations of its processes
    std::size_t turns_told = 0;
    Time last{};
    std::optional<Time> end;
    std::string why;
};

} // namespace placedpar::test
