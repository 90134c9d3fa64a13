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
        "e778626f0b7a8e05", "6f8ee142fb07732a", "a94a2f9437c800ac", "235793eaba402db1", "3b7296548b3c8ba3",
        "f75041c842af0233", "b0433d3e5b7306a6", "858a06e99b3ff623", "03388d11b753d574", "355406483c50b5a6",
        "6f68006441feccfa", "be760c61294ce775", "85630f4fbdff26e7", "bd1d3bc393e363ca", "b117af6321cecbdf",
        "340e45d03ad4cbd2", "f3803dd121a43951", "240205a86a4231cb", "4b29682fc9837d03", "f68d56aab0aaa1e6"};
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

TEST_CASE("random machines that once made a difference make none") {
    Tally tally;
    compare_random_machines({3'908}, tally);
}

TEST_CASE("a hundred thousand of them do" * doctest::skip()) {
    Tally tally;
    compare_random_machines(seeds(100'000, 2'000), tally);
    if (all_seeds())
        check_that_they_have_everything(tally, 100'000);
}
