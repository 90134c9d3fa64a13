// Tests the closed form of links against a simulation of every byte, on random machines that combine all features of
// links. Tests both against fingerprints of earlier versions.

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

/// Counts the log's entries by the first word of each entry.
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

TEST_CASE("random machines have the same log, to the picosecond, with the closed form and with every byte") {
    // These are the fingerprints of the logs of each hundred machines. A change that alters one must explain why.
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

TEST_CASE("random machines that once showed an error have the same log with the closed form") {
    Tally tally;
    compare_random_machines({56,   // an adapter's program read a byte that its sender had withdrawn
                             357,  // periods longer than two milliseconds
                             390,  // a message that was given up affected the next message to an adapter
                             545}, // a message was given up while the end of its previous part was on the wire
                            tally);
}

TEST_CASE("a hundred thousand random machines have the same log with the closed form and with every byte" *
          doctest::skip()) {
    // These are the fingerprints of the logs of each thousand machines.
    constexpr std::array<std::string_view, 100> fingerprints{
        "8f9024c448682551", "0a3598e8a763eeb9", "73ee11e2837ec86e", "bde6f06d81ddb840", "28193fd6d18896d2",
        "ea691fe65ad28598", "09bc021fb9fb0b19", "92daf183b71d606b", "6c2ca0b3c12c01b1", "6896e5f47085a9a1",
        "22dc240e45120240", "c813e0ee7703eb51", "7b1d65d35492aad9", "5ae766cf8675680f", "f6b5e9317c0e101b",
        "26890520b464161b", "7521ae903f98ddad", "ecdfffe9eb43c3d8", "55fdcbcdc2ef4562", "ad25f6269233c1e6",
        "851aaaf3c3593cae", "a80a90f4ffc74c9f", "21cc24fdb3d6f7d8", "afb72a7e928c237c", "c595b38614d0d821",
        "0ec3dc074b8f1fc5", "1316f2bfd92aeab8", "b3f94f03f274f7d3", "244d5c5c9b178b9a", "6323460a39b1c216",
        "eed8964934d5728c", "09a32eefaafbce1f", "c62e88ec09b2897b", "71da9d0b263eac31", "64be65ea64fb7e20",
        "941011a0842a9712", "487125f9f7052269", "4c1003360feaccad", "41aa262f7a1dfbcd", "ae2a0091163b69bc",
        "b35921c44dfd06e5", "b857684d263915ec", "35cd200069658f8b", "3c8ab4d65ddc9142", "b39bfbb028967f90",
        "a8c90b4a4d412b74", "44ce796b97faa14a", "3fcdf1d6dba4abf0", "3ca1ced1b67ae9a0", "3c1d9c27e2a06ba9",
        "2c1b3b650469ffb6", "e41e6db9110ec9dc", "f6ff22d438090e94", "a054dfca3cdc9ce1", "d3d36f8c327956b9",
        "e81e79da9c5fd40b", "f95a3430dd53b29a", "92334290dcf11340", "0ec9c47ca8eec1ce", "bb50210305b63f49",
        "624ab5df690b64de", "be99ba3a40321665", "54cacd6356b279af", "db8f1e5e17692862", "40b410c93b7d24bf",
        "159453b1bd948a0a", "012e78beb218334d", "6d702f7ff6d9231a", "58a9b22bab1601b7", "8c3d807e117182f4",
        "8a108141d518cbd8", "b57ea65f7ff59bc5", "d89c694c4a6d223d", "72da44adf6b96a89", "45f30a84d880b788",
        "5313a52a0da4004c", "88be8d42dc7ca77b", "8c90aaf5f030402c", "82679dd45ece5ed8", "c9bc6ca8483be52e",
        "683003399fe5b772", "5a34edb13075aae1", "a10a7bf7d2a3f993", "0fe191315d35db59", "ed600fc32d80df34",
        "01229db0af6baf7c", "b4191321a93412f8", "3d2182bac11e4ea1", "6dfcdeaef7549e57", "ee771f8b301ce721",
        "ed22949fae249d38", "94cc016b696c316e", "e13e3c6d927b0ac7", "443fddb1767d6a29", "e129deae8aaa8c8b",
        "df2ea21651d647ad", "7fe9693c680b33fa", "5580745c853bcb6d", "a19375367ca09193", "db0f976ea3c383bd"};
    Tally tally;
    if (!all_seeds())
        return void(compare_random_machines(seeds(1), tally));
    for (std::size_t i = 0; i < fingerprints.size(); ++i) {
        CAPTURE(i);
        CHECK(compare_random_machines(seeds(1'000, 2'000 + 1'000 * i), tally) == fingerprints[i]);
    }
    check_that_they_have_everything(tally, 100'000);
}
