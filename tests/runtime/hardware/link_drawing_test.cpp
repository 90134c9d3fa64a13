// Tests that the drawing of two bytes in runtime/hardware/README.md agrees with the runtime.

#include "runtime/hardware/link_state.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

struct Entry {
    LinkStep step;
    Time at;
};

/// Returns all steps of a part of two bytes from a to b. The receiver waits.
std::vector<Entry> two_bytes(const PacketTimes& times) {
    LinkState state;
    state.directions[0].receiver = LinkState::Receiver::waits;
    state.directions[0].part_bytes = state.packets.streams[0].bytes_left = 2;
    state.ask_for_byte(0, Time{0});
    std::vector<Entry> trace;
    for (LinkState::Next next = state.next(); next.at != never; next = state.next()) {
        trace.push_back({next.step, next.at});
        state.perform(next, times);
    }
    return trace;
}

constexpr Time column = 20ns;
std::size_t column_of(Time at) { return static_cast<std::size_t>(at / column); }

/// Draws one wire. Its packets begin at the steps `begins` and last for `carried`.
std::string wire(const std::vector<Entry>& trace, LinkStep begins, Time carried, char mark) {
    std::string line(column_of(1200ns), '.');
    for (const Entry& entry : trace)
        if (entry.step == begins)
            line.replace(column_of(entry.at), column_of(carried), std::string(column_of(carried), mark));
    return line;
}

/// Describes a step. `bytes` and `acknowledges` count those that have begun so far.
std::string what_happens(LinkStep step, int bytes, int acknowledges) {
    switch (step) {
    case LinkStep::byte_begins: return fmt::format("byte {} begins", bytes);
    case LinkStep::acknowledge_begins:
        return fmt::format("acknowledge {} begins{}", acknowledges,
                           acknowledges == 2 ? ": the message is handed over" : "");
    case LinkStep::sending_ends: return fmt::format("acknowledge {} has arrived: the sender goes on", acknowledges);
    case LinkStep::last_byte_arrives: return fmt::format("byte {} has arrived: the receiver goes on", bytes);
    default: return "another step";
    }
}

std::string drawing() {
    const PacketTimes times{LinkTiming{}};
    const std::vector<Entry> trace = two_bytes(times);
    std::string ruler(column_of(1200ns), ' ');
    for (Time at{}; at < 1200ns; at += 200ns)
        ruler.replace(column_of(at), 1, "|");
    ruler.erase(ruler.find_last_of('|') + 1);
    std::string text = "               " + ruler + "\n";
    text += "bytes, a to b  " + wire(trace, LinkStep::byte_begins, times.byte().carried, '=') + "\n";
    text += "acks, b to a   " + wire(trace, LinkStep::acknowledge_begins, times.acknowledge().carried, '=') + "\n\n";
    int bytes = 0, acknowledges = 0;
    for (const Entry& entry : trace) {
        bytes += entry.step == LinkStep::byte_begins;
        acknowledges += entry.step == LinkStep::acknowledge_begins;
        text += fmt::format("{:>5} ns  {}\n", entry.at / 1ns, what_happens(entry.step, bytes, acknowledges));
    }
    return text;
}

} // namespace

TEST_CASE("the drawing of two bytes and their acknowledges in the README agrees with the link") {
    std::ifstream page(PLACEDPAR_SOURCE_DIR "/runtime/hardware/README.md");
    REQUIRE(page);
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    INFO(drawing());
    CHECK(text.find(drawing()) != std::string::npos);
}
