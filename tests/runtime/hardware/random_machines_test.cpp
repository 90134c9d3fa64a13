// The closed form of links against every byte, where everything meets that links have to do with; and both against what
// they did before.

#include "random_machine.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// How often each thing was done in them, by the first words of its entry in the log.
using Tally = std::map<std::string, std::uint64_t>;

std::string report_of(const RunResult& result) { return result.deadlock ? result.deadlock->text() : ""; }

void mix_run(Fingerprint& fingerprint, const RunResult& result, const RandomMachine& machine) {
    fingerprint.mix(static_cast<std::uint64_t>(result.ending));
    fingerprint.mix(static_cast<std::uint64_t>(result.time.count()));
    for (const auto& [time, what, value] : machine.log()) {
        fingerprint.mix(static_cast<std::uint64_t>(time));
        for (char each : what)
            fingerprint.mix(static_cast<unsigned char>(each));
        fingerprint.mix(static_cast<std::uint64_t>(value));
    }
}

void compare_random_machine(std::uint64_t seed, Tally& tally, Fingerprint& fingerprint) {
    INFO(replay(seed));
    RandomMachine bytes(seed, true), closed(seed, false);
    RunResult by_bytes = bytes.run(), by_form = closed.run();
    REQUIRE(by_form.ending == by_bytes.ending);
    REQUIRE(by_form.time == by_bytes.time);
    REQUIRE(by_form.fingerprint == by_bytes.fingerprint);
    REQUIRE(report_of(by_form) == report_of(by_bytes));
    REQUIRE(std::ranges::equal(closed.log(), bytes.log()));
    REQUIRE(closed.lanes_are_whole());
    mix_run(fingerprint, by_form, closed);
    ++tally[name_of(by_form.ending)];
    for (const auto& [time, what, value] : closed.log())
        ++tally[what.substr(0, what.find(" on "))];
    for (const std::string& feature : closed.features())
        ++tally[feature];
}

std::string compare_random_machines(const std::vector<std::uint64_t>& seeds, Tally& tally) {
    Fingerprint fingerprint;
    for (std::uint64_t seed : seeds)
        compare_random_machine(seed, tally, fingerprint);
    return fmt::format("{:016x}", fingerprint.value());
}

void check_that_they_have_everything(Tally& tally, std::uint64_t machines) {
    for (std::string what :
         {"has sent", "has sent in time", "has received", "has received in time", "has given up output",
          "has given up input", "has chosen", "has computed", "memory", "trace: carries"}) {
        CAPTURE(what);
        CHECK(tally[what] > machines / 2);
    }
    for (std::string what : {"faults", "switch", "packets", "adapter", "slow links", "computing", "completed",
                             "deadlock", "stopped at the time limit"}) {
        CAPTURE(what);
        CHECK(tally[what] > machines / 20);
    }
}

} // namespace

TEST_CASE("random machines and programs do the same, to the picosecond, with the closed form and with every byte") {
    // Of all that each hundred of them log. A change that alters one says why.
    constexpr std::array<std::string_view, 20> fingerprints{
        "ed6191c60fbbaffa", "832d23d43d03ff11", "60552bf693d994e3", "67c77b1e54180c3f", "fd816ce136f70da0",
        "8c6c4400d5e80612", "e6ee69470ad42205", "7ecf4c6ba6f9cfb2", "57158845b9d601ad", "728759a917c19ee3",
        "0068f2318c0ba3fc", "1508651a40d69607", "3990d23ce76f865f", "af8991fe550d7a41", "dfb9d7fc4d306d6d",
        "ec419e37e24929d1", "fe05180d61c3fc86", "020f8cd3c26631db", "0cf3e59af5041578", "8dc3b0f9097a6c8a"};
    constexpr std::size_t hundreds = sanitized ? 1 : fingerprints.size();
    Tally tally;
    if (!all_seeds())
        return void(compare_random_machines(seeds(1), tally));
    for (std::size_t i = 0; i < hundreds; ++i) {
        CAPTURE(i);
        CHECK(compare_random_machines(seeds(100, 100 * i), tally) == fingerprints[i]);
    }
    check_that_they_have_everything(tally, 100 * hundreds);
}

TEST_CASE("random machines by which a fault was found make no difference") {
    Tally tally;
    compare_random_machines({56,   // an adapter's program read a byte that its sender had taken back
                             357,  // periods of more than two milliseconds
                             390,  // a message to an adapter that had to do with the one given up before it
                             545}, // given up while the end of the part before was on the wire
                            tally);
}

TEST_CASE("a hundred thousand of them do" * doctest::skip()) {
    Tally tally;
    compare_random_machines(seeds(100'000, 2'000), tally);
    if (all_seeds())
        check_that_they_have_everything(tally, 100'000);
}
