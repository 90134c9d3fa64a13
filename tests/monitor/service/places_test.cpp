#include "monitor/service/places.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar::monitor;
using Clock = MachinePlaces::Clock;

namespace {

Clock::time_point at(int s) { return Clock::time_point(std::chrono::seconds(s)); }

constexpr std::size_t limit = 256;

/// Connects one peer until all places are taken or it is refused; returns how many connections it has.
std::size_t crowd_in(std::vector<Occupant>& places, const std::string& peer, std::size_t attempts, bool known = false) {
    for (std::size_t i = 0; i < attempts; ++i) {
        if (places.size() >= limit) {
            auto victim = gives_way(places, peer, false);
            if (!victim)
                break;
            places.erase(places.begin() + static_cast<std::ptrdiff_t>(*victim));
        }
        places.push_back({peer, known, false, 0, at(static_cast<int>(i))});
    }
    return static_cast<std::size_t>(std::ranges::count(places, peer, &Occupant::peer));
}

bool always(const std::string&) { return true; }
bool never(const std::string&) { return false; }

} // namespace

TEST_CASE("two peers that hold all places give way to a third peer until all have equal numbers of places") {
    std::vector<Occupant> places;
    CHECK(crowd_in(places, "flooder", 128) == 128);
    CHECK(crowd_in(places, "other flooder", 128) == 128);
    CHECK(crowd_in(places, "third", 1) == 1);
    CHECK(crowd_in(places, "third", 1000) == 85);
    CHECK(crowd_in(places, "flooder", 1000) + crowd_in(places, "other flooder", 1000) ==
          171); // neither takes a place from the other
    CHECK(std::ranges::count(places, std::string("third"), &Occupant::peer) == 85);
    CHECK(places.size() == limit);
}

TEST_CASE("kept places are not given away even if all others are taken") {
    std::vector<Occupant> places;
    crowd_in(places, "site", 100, true);
    crowd_in(places, "flooder", 1000);
    CHECK(crowd_in(places, "site", 1000) == 100 + 78); // unknown machines of both peers get equal shares
    CHECK(crowd_in(places, "flooder", 1000) == 78);
    CHECK(std::ranges::count(places, true, &Occupant::kept) == 100);
}

TEST_CASE(
    "within a peer, idle machines go first, then machines with the fewest samples, then the longest silent machines") {
    std::vector<Occupant> places{{"p", false, false, 0, at(3)}, {"p", false, false, 0, at(2)},
                                 {"p", false, false, 9, at(1)}, {"p", false, true, 9, at(9)},
                                 {"q", false, true, 0, at(0)},  {"p", true, true, 0, at(0)}};
    CHECK(gives_way(places, "new", false) == 3);
    places.erase(places.begin() + 3);
    CHECK(gives_way(places, "new", false) == 1);
    places.erase(places.begin() + 1);
    CHECK(gives_way(places, "new", false) == 0);
    CHECK(gives_way(places, "q", false) == 2);  // p does not have enough more places than q, so q's own idle connection
                                                // gives way
    CHECK_FALSE(gives_way(places, "p", false)); // p itself has most connections, all in use
    CHECK(gives_way(places, "p", true) == 0);   // a known machine wins a place
    CHECK_FALSE(gives_way(std::span(places).last(1), "new", true));
}

TEST_CASE("a machine becomes known by the number of its samples and their time span") {
    ServiceLimits limits;
    MachinePlaces machines(limits);
    machines.introduced("m", "p", at(0));
    CHECK_FALSE(machines.heard("m", 100000, at(1)));
    CHECK_FALSE(machines.heard("m", 100000, at(700))); // no sample has arrived since
    CHECK(machines.heard("m", 100001, at(701)));
    CHECK(machines.known("m"));
    CHECK_FALSE(machines.heard("m", 0, at(702))); // the machine starts again from 0 samples
    CHECK_FALSE(machines.known("m"));
    machines.introduced("slow", "p", at(0));
    CHECK_FALSE(machines.heard("slow", 1, at(0)));
    CHECK_FALSE(machines.heard("slow", limits.known_samples - 1, at(10000)));
    CHECK(machines.heard("slow", limits.known_samples, at(10001)));
}

TEST_CASE("many known machines of one peer do not keep out other peers' machines") {
    ServiceLimits limits;
    MachinePlaces machines(limits);
    std::size_t count = 0;
    auto introduce = [&](const std::string& name, const std::string& peer, std::uint64_t samples, auto idle) {
        if (machines.introduced_by(peer) >= limits.machines_per_peer || count >= limits.machines) {
            auto other = machines.gives_way(peer, machines.introduced_by(peer) >= limits.machines_per_peer, idle);
            if (!other)
                return false;
            CHECK_FALSE(machines.known(*other));
            machines.forgotten(*other);
            --count;
        }
        ++count;
        machines.introduced(name, peer, at(0));
        machines.heard(name, 1, at(0));
        machines.heard(name, samples, at(1000));
        return true;
    };
    auto known = [&](const char* prefix) {
        std::size_t found = 0;
        for (int i = 0; i < 2000; ++i)
            found += machines.known(fmt::format("{} {}", prefix, i));
        return found;
    };
    for (int i = 0; i < 400; ++i)
        CHECK(introduce(fmt::format("site {}", i), "site", 5000, always));
    for (int i = 0; i < 2000; ++i) // all have been connected for long, and none is idle
        introduce(fmt::format("flood {}", i), "flooder", 5000, never);
    CHECK(known("site") == 400);
    CHECK(known("flood") == most_kept(limits.machines_per_peer));
    for (int i = 0; i < 200; ++i) // machines that the flooder itself replaces, since they are idle
        CHECK(introduce(fmt::format("own {}", i), "flooder", 1, always));
    for (int i = 0; i < 100; ++i)
        CHECK(introduce(fmt::format("new {}", i), "newcomer", 5000, never));
    CHECK_FALSE(introduce("new 100", "newcomer", 5000, never)); // this peer has as many unknown machines as the flooder
    CHECK(known("new") == 875 - 437 - 400);
    CHECK(known("site") == 400);
}

TEST_CASE("restored machines count as known within the limit of kept places") {
    ServiceLimits limits;
    limits.machines = 8;
    MachinePlaces machines(limits);
    for (int i = 0; i < 8; ++i)
        machines.restored(fmt::format("m{}", i), i > 0 && i < 6 ? 9000 : 8 - static_cast<std::uint64_t>(i), at(0));
    for (int i = 0; i < 8; ++i)
        CHECK(machines.known(fmt::format("m{}", i)) == (i < 7));
    CHECK_FALSE(machines.gives_way("p", false, always)); // each peer has one machine
    machines.restored("name", 0, at(0));
    CHECK_FALSE(machines.known("name"));
    CHECK(machines.gives_way("p", false, always) == "name");
    machines.forgotten("name");
    machines.introduced("new", "p", at(0));
    machines.heard("new", 1, at(0));
    CHECK(machines.heard("new", 5000, at(1000))); // replaces a machine with two samples
    CHECK_FALSE(machines.known("m6"));
    machines.introduced("newer", "p", at(0));
    machines.heard("newer", 1, at(0));
    CHECK(machines.known("m0"));
    CHECK(machines.heard("newer", 5000, at(1000))); // replaces the next machine, which has eight samples
    CHECK_FALSE(machines.known("m0"));
    machines.introduced("newest", "p", at(0));
    machines.heard("newest", 1, at(0));
    CHECK_FALSE(machines.heard("newest", 5000, at(1000)));
    CHECK(machines.known("m5"));
}
