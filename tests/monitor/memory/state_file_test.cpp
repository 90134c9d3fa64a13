#include "monitor/memory/state_file.hpp"
#include "scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <thread>
#include <tuple>
#include <vector>

using namespace placedpar;
using namespace placedpar::monitor;

namespace {

constexpr std::uint64_t most_history = 20;

/// Everything that a state file returns when it is opened.
struct Everything {
    StateContent content;
    std::vector<KeptEstimate> estimates;
    std::vector<KeptAlarm> alarms;

    explicit Everything(const std::filesystem::path& path) {
        StateFile file(path, "settings", most_history, content);
        for (const char* machine : {"a", "b", "c"})
            std::ranges::copy(file.history().estimates(machine, 100), std::back_inserter(estimates));
        alarms = file.history().alarms("", 100);
    }
    friend bool operator==(const Everything& x, const Everything& y) {
        return std::tie(x.content.machines, x.content.messages, x.content.last_message, x.estimates, x.alarms) ==
               std::tie(y.content.machines, y.content.messages, y.content.last_message, y.estimates, y.alarms);
    }
};

KeptEstimate estimate(const char* machine, int i) {
    return {machine, 1e9 + i, 0.5 * i, "P1b", "BO", 0.0086 + 1e-5 * i, i % 3 ? std::optional(1e-4) : std::nullopt};
}

KeptAlarm alarm(const char* machine, const char* kind, int i) {
    return {machine, kind, "BU BO", "a sentence", 1e9 + i, 0.25 * i, std::nullopt, std::nullopt, std::nullopt};
}

Transaction transaction_of(int i) {
    Transaction transaction;
    const char* machine = i % 2 ? "a" : "b";
    transaction.entries.push_back(
        KeptMessage{static_cast<std::uint64_t>(i), machine, fmt::format("{{\"message\":{}}}", i)});
    transaction.entries.push_back(estimate(machine, i));
    if (i % 7 == 5)
        transaction.entries.push_back(KeptState{machine, static_cast<std::uint64_t>(i), std::string(3000, 'x')});
    if (i % 10 == 6)
        transaction.entries.push_back(alarm(machine, i % 20 == 6 ? "leak" : "drift", i));
    return transaction;
}

/// Commits units 1 to 60 in transactions of two, and copies the file to another folder as a kill would leave it.
void write_and_kill(const Scratch& from, const Scratch& to) {
    StateContent content;
    StateFile file(from / "state", "settings", most_history, content);
    for (int i = 1; i < 60; i += 2) {
        std::vector<Transaction> transactions{transaction_of(i), transaction_of(i + 1)};
        file.commit(transactions);
    }
    to.write("state", from.read("state"));
}

std::string flipped(std::string text, std::size_t bit) {
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
    return text;
}

/// The contents of a folder's state file and journal; "" if a file is missing.
struct Files {
    std::string state, journal;

    explicit Files(const Scratch& from) : state(from.read("state")), journal(from.read("state-journal")) {}
    void write(const Scratch& to) const {
        to.write("state", state);
        if (!journal.empty())
            to.write("state-journal", journal);
    }
};

/// Returns whether the files can be opened, and checks that they then give `whole`. Refused files without a journal
/// must be unchanged.
bool accepted(const Files& files, const Everything& whole) {
    Scratch scratch;
    files.write(scratch);
    try {
        Everything everything(scratch / "state");
        CHECK(everything == whole);
        return true;
    } catch (const UserError& error) {
        CHECK(std::string(error.what()).find((scratch / "state").string()) != std::string::npos);
        CHECK((!files.journal.empty() || scratch.read("state") == files.state));
        return false;
    }
}

/// Returns the files after a kill in the middle of a transaction: when a file first grows beyond `bytes`.
Files killed_in_commit(const Files& files, std::size_t bytes) {
    Scratch scratch;
    files.write(scratch);
    if (const pid_t child = ::fork(); child == 0) {
        StateContent content;
        StateFile file(scratch / "state", "settings", most_history, content);
        std::vector<Transaction> transactions;
        for (int i = 61; i < 1000; ++i)
            transactions.push_back(transaction_of(i));
        const FullDisk disk(bytes);
        std::signal(SIGXFSZ, SIG_DFL);
        file.commit(transactions);
        ::_exit(0);
    } else {
        int status = 0;
        ::waitpid(child, &status, 0);
        REQUIRE(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == SIGXFSZ);
    }
    return Files(scratch);
}

/// Returns every third bit of the first bytes, and one bit in `step` of the rest. If `step` is odd, every position
/// within a byte occurs.
std::vector<std::size_t> some_bits(const std::string& text, std::size_t first_bytes, std::size_t step) {
    std::vector<std::size_t> bits;
    for (std::size_t bit = 0; bit < 8 * text.size(); bit += bit < 8 * first_bytes ? 3 : step)
        bits.push_back(bit);
    return bits;
}

} // namespace

TEST_CASE("committed state is restored after a kill and after a clean end") {
    Scratch first, killed;
    write_and_kill(first, killed);
    Everything clean(first / "state"), after_kill(killed / "state");
    CHECK(clean == after_kill);
    CHECK(clean.content.machines.size() == 2);
    CHECK(clean.content.messages.size() == 60);
    CHECK(clean.content.messages[41] == KeptMessage{42, "b", "{\"message\":42}"});
    CHECK(clean.estimates.size() == 2 * most_history);
    CHECK(clean.estimates.front() == estimate("a", 59));
    CHECK(clean.alarms.size() == 6);
}

TEST_CASE("every flipped bit in the used part of a state file is detected") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    Everything whole(scratch / "state");
    Files files(scratch);
    int refused = 0;
    for (std::size_t bit : some_bits(files.state, 100, 2039)) {
        CAPTURE(bit);
        Files damaged = files;
        damaged.state = flipped(files.state, bit);
        refused += !accepted(damaged, whole);
    }
    CHECK(refused > 100);
}

TEST_CASE("a state file that is cut off anywhere is refused") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    Everything whole(scratch / "state");
    Files files(scratch);
    for (std::size_t size = 0; size < files.state.size(); size += 1021) {
        CAPTURE(size);
        Files cut = files;
        cut.state.resize(size);
        CHECK_FALSE(accepted(cut, whole));
    }
    files.state.pop_back();
    CHECK_FALSE(accepted(files, whole));
}

TEST_CASE("a kill within a transaction loses nothing, and damage to the remaining journal is detected") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    const Everything whole(scratch / "state");
    const Files before(scratch);
    int half_written = 0, refused = 0;
    for (std::size_t bytes = 4096; half_written < 4; bytes += 2 * 4096) {
        REQUIRE(bytes <= before.state.size() + 8 * 4096);
        CAPTURE(bytes);
        const Files files = killed_in_commit(before, bytes);
        CHECK(accepted(files, whole));
        Files damaged = files;
        damaged.journal.clear();
        if (files.state == before.state || files.journal.empty() || accepted(damaged, whole))
            continue; // only the heading has been written so far
        ++half_written;
        for (std::size_t size = 1; size < files.journal.size(); size += 4001) {
            damaged.journal = files.journal.substr(0, size);
            refused += !accepted(damaged, whole);
        }
        for (std::size_t bit : some_bits(files.journal, 28, 40009)) {
            damaged.journal = flipped(files.journal, bit);
            refused += !accepted(damaged, whole);
        }
    }
    CHECK(refused > 30);
}

TEST_CASE("a mixture of rows of two transactions is detected") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    for (const char* change : {"DELETE FROM estimates WHERE machine = 'a' AND number = 20", "DELETE FROM alarms",
                               "DELETE FROM machines WHERE name = 'b'"}) {
        Scratch damaged;
        damaged.write("state", scratch.read("state"));
        {
            store::Database database(damaged / "state");
            const std::string sum = fmt::format("{}", database.integer("SELECT sum FROM ledger"));
            database.run(change);
            database.run("UPDATE ledger SET sum = " + sum);
        }
        StateContent content;
        CHECK_THROWS_WITH_AS(StateFile(damaged / "state", "settings", most_history, content),
                             doctest::Contains("its rows do not match the sum of their checksums"), UserError);
    }
}

TEST_CASE("a file of an earlier version is renamed with its companion files, and a new file is begun") {
    Scratch scratch;
    std::string text;
    {
        StateContent content;
        StateFile(scratch / "state", "settings", most_history, content);
        text = scratch.read("state");
        text[63] = 2;
    }
    scratch.write("state", text);
    scratch.write("state-wal", "a log");
    scratch.write("state-journal", "a journal");
    const Everything everything(scratch / "state");
    CHECK(everything.content.said.find("the file had version 2, from an earlier placedpar monitor") !=
          std::string::npos);
    CHECK(everything.content.machines.empty());
    CHECK(scratch.read("state.version-2") == text);
    CHECK(scratch.read("state.version-2-wal") == "a log");
    CHECK(scratch.read("state.version-2-journal") == "a journal");
    scratch.write("state", text);
    StateContent content;
    CHECK_THROWS_WITH_AS(StateFile(scratch / "state", "settings", most_history, content),
                         doctest::Contains("move one of the two away"), UserError);
}

TEST_CASE("a start after an interrupted rename of the earlier file reports it once") {
    Scratch scratch;
    scratch.write("state.version-2", "the earlier file");
    auto said = [&] { return Everything(scratch / "state").content.said; };
    CHECK(said().find("the file had version 2, from an earlier placedpar monitor: it was renamed to") !=
          std::string::npos);
    CHECK(said() == "");
    CHECK(scratch.read("state.version-2") == "the earlier file");
}

TEST_CASE("a forgotten machine leaves only its messages") {
    Scratch scratch;
    {
        StateContent content;
        StateFile file(scratch / "state", "settings", most_history, content);
        std::vector<Transaction> transactions{transaction_of(1), transaction_of(2), transaction_of(5),
                                              transaction_of(6)};
        transactions[2].entries[0] = KeptMessage{3, "a", "x"};
        transactions[3].entries[0] = KeptMessage{4, "b", "x"};
        file.commit(transactions);
        std::vector<Transaction> forget{{{KeptMessage{5, "a", forget_text}, ForgottenMachine{"a"}}}};
        file.commit(forget);
    }
    Everything everything(scratch / "state");
    CHECK(everything.content.machines.empty());
    CHECK(everything.content.messages.size() == 5);
    for (const KeptEstimate& each : everything.estimates)
        CHECK(each.machine == "b");
    CHECK(everything.alarms.size() == 1);
}

TEST_CASE("after a loss the file is written anew, and alarms that ended meanwhile are cleared") {
    Scratch scratch;
    StateContent content;
    StateFile file(scratch / "state", "settings", most_history, content);
    std::vector<Transaction> transactions{transaction_of(1)};
    transactions[0].entries.push_back(alarm("a", "leak", 1));
    file.commit(transactions);
    {
        FullDisk disk(1);
        std::vector<Transaction> lost{transaction_of(2)};
        CHECK_THROWS_AS(file.commit(lost), store::DatabaseError);
    }
    Transaction anew{{OpenAlarms{{alarm("b", "drift", 3)}, 5}, KeptState{"b", 7, "s"}}, 7};
    file.commit(std::span(&anew, 1));
    CHECK(file.history().open_alarms() == std::vector<KeptAlarm>{alarm("b", "drift", 3)});
    CHECK(file.history().alarms("a", 10).at(0).cleared_at == 5);
    std::vector<Transaction> next{{{KeptMessage{8, "b", "x"}}}};
    file.commit(next);
}

TEST_CASE("a file that is removed again while being rewritten keeps its history") {
    int removed_in_between = 0;
    for (int round = 0; round < 1000 && removed_in_between < 10; ++round) { // the remover may be too late
        Scratch scratch;
        StateContent content;
        StateFile file(scratch / "state", "settings", most_history, content);
        std::vector<Transaction> transactions{transaction_of(1)};
        file.commit(transactions);
        std::filesystem::remove(scratch / "state");
        CHECK_THROWS_AS(file.commit(transactions), store::DatabaseError);
        Transaction anew{{OpenAlarms{{}, 5}, KeptState{"b", 7, "s"}}, 7};
        {
            const int watch = ::inotify_init();
            ::inotify_add_watch(watch, (scratch / "").c_str(), IN_MOVED_TO);
            std::jthread remover([&] {
                char event[1024];
                if (::read(watch, event, sizeof event) > 0)
                    std::filesystem::remove(scratch / "state");
            });
            try {
                file.commit(std::span(&anew, 1));
            } catch (const std::exception&) {
                ++removed_in_between;
            }
            remover.join();
            ::close(watch);
        }
        file.commit(std::span(&anew, 1));
        CHECK(file.history().estimates("a", 10).size() == 1);
        CHECK(std::filesystem::exists(scratch / "state"));
    }
    CHECK(removed_in_between == 10);
}

TEST_CASE("a file that is not a state file is refused with its kind and a remedy") {
    Scratch scratch;
    auto refusal = [&](const char* name) {
        StateContent content;
        try {
            StateFile(scratch / name, "settings", most_history, content);
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    auto refused = [&](const std::string& text, const char* because) {
        scratch.write("state", text);
        CAPTURE(text);
        CHECK(refusal("state") ==
              fmt::format("{}: this state file cannot be used: {}", (scratch / "state").string(), because));
        CHECK(scratch.read("state") == text);
    };
    std::string away = fmt::format(
        "; restore an undamaged copy and remove state-journal, or move {} away and start without known machines",
        (scratch / "state").string());
    refused("", ("the file is empty" + away).c_str());
    refused("rubbish", ("the file is not a state file of the monitor" + away).c_str());
    refused("{\"placedpar_monitor_state\":1,\"settings\":\"--seed 1\"",
            "an earlier placedpar monitor wrote the file as JSON, which this version cannot read; use another "
            "--state file");
    refused(
        "01234567 placedpar-monitor-journal 1 epoch 3\n",
        "the file is the journal of an earlier placedpar monitor, which this version cannot read; use another --state "
        "file");
    std::filesystem::remove(scratch / "state");
    scratch.write("state.journal", "");
    CHECK(refusal("state").find("state.journal exists, the journal of an earlier placedpar monitor") !=
          std::string::npos);
    scratch.write("state-wal", "");
    CHECK(refusal("state").find("its last changes are in ") != std::string::npos);
    std::filesystem::create_directory(scratch / "folder");
    CHECK(refusal("folder").find("this is a folder, not a state file") != std::string::npos);
    std::filesystem::create_symlink(scratch / "nothing", scratch / "link");
    CHECK(refusal("link").find("this symbolic link leads to a missing file") != std::string::npos);
}

TEST_CASE("another program's database, another version and other settings are refused and left alone") {
    Scratch scratch;
    auto refused = [&](const char* name, const char* settings, const char* because) {
        StateContent content;
        std::string before = scratch.read(name);
        CHECK_THROWS_WITH_AS(StateFile(scratch / name, settings, most_history, content), doctest::Contains(because),
                             UserError);
        CHECK(scratch.read(name) == before);
    };
    store::Database(scratch / "other").run("CREATE TABLE t(x)");
    refused("other", "settings", "the file is a database of another program (application_id 0x00000000");
    {
        StateContent content;
        StateFile(scratch / "state", "settings", most_history, content);
    }
    refused("state", "others", "the file was written with settings, but this monitor has others; use the same options");
    std::string text = scratch.read("state");
    text[63] = 9;
    scratch.write("state", text);
    refused("state", "settings", "the file has version 9, but this program reads version 4");
}

TEST_CASE("only one monitor can use a state file, by any of its names") {
    Scratch scratch;
    StateContent content;
    StateFile file(scratch / "state", "settings", most_history, content);
    std::filesystem::create_symlink(scratch / "state", scratch / "soft");
    std::filesystem::create_hard_link(scratch / "state", scratch / "hard");
    for (const char* name : {"state", "soft", "hard"})
        CHECK_THROWS_WITH_AS(StateFile(scratch / name, "settings", most_history, content),
                             doctest::Contains("another placedpar monitor is using the file"), UserError);
}
