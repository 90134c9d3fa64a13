// Tests what comes between ranks in another order, or damaged.

#include "tests/native/made_up_ranks.hpp"
#include "tests/native/ring_of.hpp"

#include <doctest/doctest.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <functional>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

TEST_CASE("parcels of a sender with one number are taken in order, whichever comes first") {
    ExpectedParcels<bool> expected;
    auto& first = expected.add(1, 5, 10);
    auto& second = expected.add(1, 5, 20);
    expected.add(2, 5, 30).request = true;
    const auto length_of_next = [&] {
        const auto taken = expected.take([](const auto& each) { return each.request; });
        return taken ? taken->bytes.size() : 0;
    };
    second.request = true;
    CHECK(length_of_next() == 30); // of another sender
    CHECK(length_of_next() == 0);
    first.request = true;
    CHECK(length_of_next() == 10);
    CHECK(length_of_next() == 20);
    CHECK(expected.empty());
}

namespace {

struct Aborted {
    bool is_aborted = false;
    std::string printed; ///< on standard error
};

/// Runs a ring whose letters are damaged, in a process of its own.
Aborted run_damaged(const std::function<void(std::vector<std::uint8_t>&)>& damage) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        dup2(ends[1], STDERR_FILENO);
        const auto relay = rank_kind("relay", [](ProcessEnvironment& environment) { relay_token(environment, 10); });
        on_ranks(2, ring_of(2, "relay"), {relay}, {.damage = damage});
        _exit(0);
    }
    close(ends[1]);
    Aborted result;
    std::array<char, 500> bytes;
    for (ssize_t read_now = 0; (read_now = read(ends[0], bytes.data(), bytes.size())) > 0;)
        result.printed.append(bytes.data(), static_cast<std::size_t>(read_now));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    result.is_aborted = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
    return result;
}

using Letter = std::vector<std::uint8_t>;
constexpr std::uint8_t of_a_process = 0; // the kind of a letter with a message

} // namespace

TEST_CASE("a damaged letter ends the program, with the ranks and what is wrong") {
    const std::pair<std::function<void(Letter&)>, std::string> damages[] = {
        {[](Letter& letter) { letter.clear(); }, "received a damaged message of 0 bytes from rank"},
        {[](Letter& letter) { letter[0] = 200; }, "its kind of message does not exist"},
        {[](Letter& letter) { letter[0] == of_a_process ? letter.resize(3) : void(); },
         "damaged message of 3 bytes from rank"},
        {[](Letter& letter) { letter[0] == of_a_process ? void(letter[2] = 77) : void(); },
         "channel 19712 does not lead to this rank"},
    };
    for (const auto& [damage, message] : damages) {
        const Aborted run = run_damaged(damage);
        CHECK(run.is_aborted);
        CHECK_MESSAGE(run.printed.find(message) != std::string::npos, run.printed);
    }
}

TEST_CASE("a message that was cut off on the way ends the run, and names the process that inputs it") {
    const auto relay = rank_kind("relay", [](ProcessEnvironment& environment) { relay_token(environment, 10); });
    const auto cut = [](Letter& letter) { letter[0] == of_a_process ? letter.resize(7) : void(); };
    const std::string what = what_was_thrown(on_ranks(2, ring_of(2, "relay"), {relay}, {.damage = cut}));
    CHECK_MESSAGE(what.find("the message is cut off") != std::string::npos, what);
    CHECK_MESSAGE(what.find("process p[") != std::string::npos, what);
}
