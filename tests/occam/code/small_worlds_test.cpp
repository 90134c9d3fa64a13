// Compiles every network of three processes with a few actions as a program of occam, and runs it: an emulated
// transputer does only what CSP allows. The worlds and their interpreter are those that C++ processes are tested with.

#include "executed.hpp"
#include "runtime/transputer/waiting.hpp"
#include "tests/runtime/every_world.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// How a world is written in occam, and compiled.
struct Wording {
    enum Protocol : std::size_t { integers, bytes, counted, tagged, arrays } protocol = integers;
    bool has_delays = false;       ///< processes wait for a timer before some actions
    bool has_time_outs = false;    ///< a poll ends by a time-out, and not by SKIP
    bool has_priorities = false;   ///< the first process has high priority
    bool has_channel_array = true; ///< channels are elements of an array
    occam::CodeOptions code{.model = transputer::Model::t800};

    /// Returns one of the wordings; all of them come in turn.
    static Wording number(std::size_t n) {
        static constexpr std::array models{transputer::Model::t800, transputer::Model::t414, transputer::Model::t425};
        Wording wording{.protocol = static_cast<Protocol>(n % 5),
                        .has_delays = n % 4 == 1,
                        .has_time_outs = n % 4 > 1,
                        .has_priorities = n % 4 == 0 && n % 3 == 0,
                        .has_channel_array = n % 7 < 4};
        wording.code = {
            .model = models[n / 2 % 3], .mode = static_cast<occam::ErrorMode>(n % 3), .vector_space = n % 2 == 0};
        return wording;
    }
    std::string text() const {
        return fmt::format("protocol {}, delays {}, time-outs {}, priorities {}, array {}, mode {}", +protocol,
                           has_delays, has_time_outs, has_priorities, has_channel_array, static_cast<int>(code.mode));
    }
};

// What the program notes in its memory
constexpr std::uint32_t has_ended = 3, notes = 4, noted = 8, trace = 32;

constexpr std::string_view declarations_of_worlds = R"(PROTOCOL SP IS INT16::[]BYTE:
PROTOCOL TAGGED
  CASE
    odd; INT
    even; BYTE
:
PROC note (VAL INT c, number, []INT memory)
  IF
    memory[8 + c] < number
      SEQ
        memory[8 + c] := number
        memory[32 + memory[4]] := c
        memory[4] := memory[4] + 1
    TRUE
      SKIP
:
#OPTION "N"
)";

/// Writes a world as a program. Message n of a channel has the value n.
class OccamText {
public:
    OccamText(const SmallWorld& world, const Wording& wording)
        : world_(world), wording_(wording), outputs_(world.channels.size()) {}

    std::string text() {
        std::string out = std::string(declarations_of_worlds) + "PROC main (CHAN OF SP fs, ts, []INT memory)\n";
        const std::size_t count = std::max<std::size_t>(world_.channels.size(), 1);
        if (wording_.has_channel_array)
            out += fmt::format("  [{}]CHAN OF {} c:\n", count, protocol());
        else
            for (std::size_t i = 0; i < count; ++i)
                out += fmt::format("  CHAN OF {} {}:\n", protocol(), channel(i));
        out += "  TIMER clock:\n  SEQ\n    SEQ i = 0 FOR 64\n      memory[i] := 0\n";
        out += indented(processes(), 4);
        return out + "    memory[3] := 1\n:\n";
    }

private:
    std::string processes() {
        if (!wording_.has_priorities)
            return "PAR\n" + indented(process(0) + process(1) + process(2), 2);
        return "PRI PAR\n" + indented(process(0) + "PAR\n" + indented(process(1) + process(2), 2), 2);
    }
    std::string protocol() const {
        static constexpr std::array<const char*, 5> protocols = {"INT", "BYTE", "INT::[]BYTE", "TAGGED", "[3]INT"};
        return protocols[wording_.protocol];
    }
    std::string channel(std::size_t i) const {
        return fmt::format(fmt::runtime(wording_.has_channel_array ? "c[{}]" : "c{}"), i);
    }
    std::string process(std::size_t p) {
        static constexpr std::array<const char*, 5> variables = {"INT x:\n", "BYTE x:\n", "INT x:\n[20]BYTE s:\n",
                                                                 "INT x:\nBYTE y:\n", "[3]INT x:\n"};
        std::string body;
        for (std::size_t k = 0; k < world_.processes[p].size(); ++k) {
            if (wording_.has_delays)
                body += fmt::format("clock ? now\nclock ? AFTER now PLUS {}\n", (5 * p + 3 * k) % 4);
            body += action(world_.processes[p][k]) + fmt::format("memory[{}] := {}\n", p, k + 1);
        }
        return std::string(variables[wording_.protocol]) + "INT now:\nSEQ\n" + indented(body, 2);
    }
    std::string action(const Action& action) {
        if (action.kind == Action::output)
            return output(action.channel);
        if (action.kind == Action::input)
            return input(action.channel);
        std::string guards;
        for (std::size_t i = 0; i < world_.channels.size(); ++i)
            if (action.is_guarded_by(i))
                guards += input(i, true);
        if (action.kind == Action::alternate)
            return "ALT\n" + indented(guards, 2);
        if (!wording_.has_time_outs)
            return "PRI ALT\n" + indented(guards, 2) + "  TRUE & SKIP\n    SKIP\n";
        return "clock ? now\nALT\n" + indented(guards, 2) + "  clock ? AFTER now PLUS 3\n    SKIP\n";
    }
    std::string output(std::size_t c) {
        const int number = ++outputs_[c];
        const std::string to = channel(c) + " ! ", noting = fmt::format("note ({}, {}, memory)\n", c, number);
        switch (wording_.protocol) {
        case Wording::integers: return fmt::format("{}{}\n", to, number) + noting;
        case Wording::bytes: return fmt::format("{}{}(BYTE)\n", to, number) + noting;
        case Wording::counted: return fmt::format("{}{}::\"abcdefghijkl\"\n", to, number) + noting;
        case Wording::arrays: return fmt::format("{}[0, 0, {}]\n", to, number) + noting;
        default:
            return (number % 2 != 0 ? fmt::format("{}odd; {}\n", to, number)
                                    : fmt::format("{}even; {}(BYTE)\n", to, number)) +
                   noting;
        }
    }
    std::string input(std::size_t c, bool is_guard = false) const {
        static constexpr std::array<const char*, 5> items = {"x", "x", "x::s", "CASE", "x"};
        static constexpr std::array<const char*, 5> values = {"x", "INT x", "x", "x", "x[2]"};
        const std::string from = fmt::format("{} ? {}\n", channel(c), items[wording_.protocol]);
        if (wording_.protocol == Wording::tagged)
            return from +
                   fmt::format("  odd; x\n    note ({0}, x, memory)\n  even; y\n    note ({0}, INT y, memory)\n", c);
        return from + (is_guard ? "  " : "") + fmt::format("note ({}, {}, memory)\n", c, values[wording_.protocol]);
    }

    const SmallWorld& world_;
    const Wording& wording_;
    std::vector<int> outputs_;
};

/// What a process waits for: its kind, and its channels by their numbers.
using WorldWait = std::pair<transputer::Wait, std::vector<std::uint32_t>>;

std::vector<WorldWait> expected_waits(const SmallWorld& world, const Interpreter::State& state) {
    std::vector<WorldWait> waits;
    for (std::size_t p = 0; p < 3; ++p) {
        if (state[p] >= world.processes[p].size())
            continue;
        const Action& action = world.processes[p][state[p]];
        WorldWait wait{transputer::Wait::output, {}};
        if (action.kind != Action::output)
            wait.first = action.is_alternation() ? transputer::Wait::alternative : transputer::Wait::input;
        for (std::uint32_t c = 0; c < world.channels.size(); ++c)
            if (action.is_guarded_by(c) || (!action.is_alternation() && action.channel == c))
                wait.second.push_back(c);
        waits.push_back(std::move(wait));
    }
    std::ranges::sort(waits);
    return waits;
}

/// Returns what the processes of a transputer wait for. The least channel that one waits for has number `least`.
std::vector<WorldWait> waits_in(const transputer::Core& core, std::uint32_t least) {
    std::vector<WorldWait> waits;
    transputer::Word first = ~transputer::Word{0};
    for (const transputer::WaitingProcess& each : waiting_processes(core)) {
        waits.emplace_back(each.wait, each.channels);
        for (const transputer::Word channel : each.channels)
            first = std::min(first, channel);
    }
    for (WorldWait& wait : waits) {
        for (std::uint32_t& channel : wait.second)
            channel = (channel - first) / 4 + least;
        std::ranges::sort(wait.second);
    }
    std::ranges::sort(waits);
    return waits;
}

void check_waits(const SmallWorld& world, const Wording& wording, const Interpreter::State& state,
                 const transputer::Core& core) {
    std::vector<WorldWait> expected = expected_waits(world, state);
    std::uint32_t least = 100;
    for (const WorldWait& wait : expected)
        least = std::min(least, *std::ranges::min_element(wait.second));
    std::vector<WorldWait> found = waits_in(core, least);
    for (std::vector<WorldWait>* waits : {&expected, &found})
        if (!wording.has_channel_array) { // only the number of channels can be compared
            for (WorldWait& wait : *waits)
                std::ranges::fill(wait.second, 0U);
            std::ranges::sort(*waits);
        }
    CHECK(found == expected);
}

void check_occam_world(const SmallWorld& world, const Wording& wording) {
    const std::string text = OccamText(world, wording).text();
    INFO(wording.text(), "; world ", world.text(), "\n", text);
    BootedCode booted(compiled_program(text, wording.code).code, wording.code);
    REQUIRE(booted.run(400'000'000));
    REQUIRE(booted.core().stopped() == transputer::Stopped::nothing);
    Interpreter interpreter(world);
    auto states = interpreter.start();
    for (int i = 0; i < booted.result(notes); ++i)
        states =
            interpreter.after(states, static_cast<std::size_t>(booted.result(trace + static_cast<std::uint32_t>(i))));
    Interpreter::State reached{};
    for (std::uint32_t p = 0; p < 3; ++p)
        reached[p] = static_cast<std::uint8_t>(booted.result(p));
    REQUIRE(states.contains(reached));
    REQUIRE(interpreter.can_end({reached}, booted.result(has_ended) == 1));
    check_waits(world, wording, reached, booted.core());
}

/// Checks all worlds in so many wordings each, which are others for each world. Returns the number of worlds.
std::size_t check_occam_worlds(const Bounds& bounds, std::size_t wordings) {
    std::size_t worlds = 0, turn = 0;
    for_every_world(bounds, [&](const SmallWorld& world) {
        ++worlds;
        for (std::size_t i = 0; i < wordings; ++i)
            check_occam_world(world, Wording::number(turn++));
    });
    return worlds;
}

} // namespace

TEST_CASE("every world of up to four actions takes a course in occam that CSP allows") {
    const Bounds bounds{.longest = 4, .polls = true, .any_guards = true, .most_in_all = 4};
    CHECK(check_occam_worlds(bounds, sanitized ? 1 : 3) == 640);
}

TEST_CASE("every world of up to two actions a process takes a course in occam that CSP allows") {
    if (!sanitized)
        CHECK(check_occam_worlds({.longest = 2}, 1) == 1233);
}

// These take minutes: ctest -C studies -L studies
TEST_CASE("all worlds of up to three actions a process take a course in occam that CSP allows" * doctest::skip()) {
    CHECK(check_occam_worlds({.longest = 2, .polls = true, .any_guards = true}, 6) == 6503);
    CHECK(check_occam_worlds({.longest = 3}, 3) == 65824);
    CHECK(check_occam_worlds({.longest = 3, .polls = true}, 1) == 406867);
}
