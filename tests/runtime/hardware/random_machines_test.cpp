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
        "1c871d41e8881059", "bd593de27bf02ce5", "391e4850e6efcfe0", "365199e1ea37a87e", "d08375f7b96ffb60",
        "d39e96dae3360b69", "e6ee69470ad42205", "eb2ab3b01ae9508b", "cdfd003bd1468c4c", "3e2718cbc8711101",
        "3b5692108c69d013", "33dcbd9aea0a45b4", "0db987a776ad243d", "dfdc8f6412647b47", "d7ce18a1447026f9",
        "b15a8a7fe97641b4", "6d896890ba7673af", "126730121cd75189", "0cf3e59af5041578", "8dc3b0f9097a6c8a"};
    Tally tally;
    if (!all_seeds())
        return void(compare_random_machines(seeds(1), tally));
    for (std::size_t i = 0; i < fingerprints.size(); ++i) {
        CAPTURE(i);
        CHECK(compare_random_machines(seeds(100, 100 * i), tally) == fingerprints[i]);
    }
    check_that_they_have_everything(tally, 100 * fingerprints.size());
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
        "9c5788ef7ee0cf64", "b400035bf710d5df", "64d109da8c72fa38", "69723f21085b320c", "147800997c305e24",
        "bf329f2bbfdaaba0", "cdfdf650e02f6b45", "b1e936b18eb685e0", "fc0616b0a47ac39f", "04d92837e0fe7233",
        "8875380166c34ae7", "c49a1cd7d4ac0d61", "4011e28f41174c78", "897a9c65a938e8ca", "d2349f6bed3a2969",
        "6bd6c70ad4602db8", "39704ea800d3d23e", "a1f88b5c29544a24", "c0a2d3bdbef9168d", "e88883c4505ef289",
        "5d0a9c096088d505", "ab5cfba089f51179", "539cb5d4c62298b3", "98d0c0f0c8776710", "1e17574b58088361",
        "ba07f1c797aa36b6", "0c02e284ae7bf351", "049c0ed768106003", "461f30d61d4277a5", "9cf8bf95d839aea7",
        "a52a6aa52769451f", "474005ce14842d73", "783a38658c8fe975", "742a3aa9630e6304", "a74fcf4c919defc5",
        "e8961f4c820c20fe", "6304e94640641dbe", "a3e1d800ebd10792", "50910dfd4b0cadb1", "52473d184c5e2d69",
        "45891d28c4c0e557", "787a902dee51d518", "fc286f36dd5c9d6c", "c5b5d89968731c0e", "1056de3cfbe77a8b",
        "7502f0b8b26dc319", "88e5215ed261c3d6", "0a688192df61ba0d", "c466f6ffde55407a", "f7ae7e4446637280",
        "e5ede2bcb86d5fcb", "f6cabe9de9a3ceb0", "1f35eb01389dcca7", "6af94be464f9c52e", "f27fa6f63b2696fe",
        "12b5ad0fe6169bf1", "c2e9efbb070065d0", "beb813e8311ee49b", "2a71313e50e8e7dc", "f48a50afecfcd90d",
        "d38ef1f453dd782e", "2fdd03605d310be9", "677291b8847eb3de", "a99a0ddb9e20bea2", "8a478d77b07b6716",
        "bc945574818a5291", "2a98ec82ebaebc0b", "8d1ffdc822ba44c9", "1a959ff2ca9b0c78", "49b13c448e4f4632",
        "6d5fba8feddfb3da", "d8a0b8bf05c7b93b", "6d27be6fa6cdef68", "4a60cd9cfd5c173b", "db408f6104ea9c87",
        "9eaf6d0ef7d5f2a0", "4d9821fa333025c9", "b93757b78be72f36", "ee25e008e9d07e78", "d6886c7c8a32c249",
        "86c8f75afecbf07f", "09accf7c5b1e92d0", "9e48992c18acbc19", "65ed4a6ab585082c", "abda8435bc6aabd6",
        "1c5e4ff8cac2e705", "498b5c059f855521", "d086c5cc4b6f1bff", "db5e3949796716e1", "6e74231f63a6fad8",
        "e5a2b343f4505338", "295e1e0cc500d427", "0b545d778f2f04a6", "cf3636e5dbdfb43e", "905a8fe97994e8af",
        "1a534655697dd6a1", "22a2c89f675e7c0b", "49926323daf7ba58", "84fabac4eaba5a57", "67ce303037a06cef"};
    Tally tally;
    if (!all_seeds())
        return void(compare_random_machines(seeds(1), tally));
    for (std::size_t i = 0; i < fingerprints.size(); ++i) {
        CAPTURE(i);
        CHECK(compare_random_machines(seeds(1'000, 2'000 + 1'000 * i), tally) == fingerprints[i]);
    }
    check_that_they_have_everything(tally, 100'000);
}
