#include "monitor/memory/state_file.hpp"
#include "scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <sys/inotify.h>
#include <unistd.h>

#include <string>
#include <thread>
#include <tuple>
#include <vector>

using namespace placedpar;
using namespace placedpar::monitor;

namespace {

constexpr std::uint64_t most_history = 20;

/// All that a file gives back.
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

Parcel parcel_of(int i) {
    Parcel parcel;
    const char* machine = i % 2 ? "a" : "b";
    parcel.entries.push_back(KeptMessage{static_cast<std::uint64_t>(i), machine, fmt::format("{{\"message\":{}}}", i)});
    parcel.entries.push_back(estimate(machine, i));
    if (i % 7 == 5)
        parcel.entries.push_back(KeptState{machine, static_cast<std::uint64_t>(i), std::string(3000, 'x')});
    if (i % 10 == 6)
        parcel.entries.push_back(alarm(machine, i % 20 == 6 ? "leak" : "drift", i));
    return parcel;
}

/// Units 1 to 60 in transactions of two; the file is as a kill leaves it, in another folder.
void write_and_kill(const Scratch& from, const Scratch& to) {
    StateContent content;
    StateFile file(from / "state", "settings", most_history, content);
    for (int i = 1; i < 60; i += 2) {
        std::vector<Parcel> parcels{parcel_of(i), parcel_of(i + 1)};
        file.commit(parcels);
    }
    for (const char* name : {"state", "state-wal", "state-mark"})
        to.write(name, from.read(name));
}

std::string flipped(std::string text, std::size_t bit) {
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
    return text;
}

/// The files of a folder, "" for one that is not there.
struct Files {
    std::string state, log, mark;

    explicit Files(const Scratch& from)
        : state(from.read("state")), log(from.read("state-wal")), mark(from.read("state-mark")) {}
};

/// Opened, they give what is `whole`; false when they are refused, and left as they are.
bool accepted(const Files& files, const Everything& whole) {
    Scratch scratch;
    scratch.write("state", files.state);
    if (!files.log.empty())
        scratch.write("state-wal", files.log);
    if (!files.mark.empty())
        scratch.write("state-mark", files.mark);
    try {
        Everything everything(scratch / "state");
        CHECK(everything == whole);
        return true;
    } catch (const UserError& error) {
        CHECK(std::string(error.what()).find((scratch / "state").string()) != std::string::npos);
        CHECK(scratch.read("state") == files.state);
        return false;
    }
}

/// Of all bits of a text those of its first bytes, and of every so many: with a step that shares no factor with eight
/// each of a byte's bits has its turn.
std::vector<std::size_t> some_bits(const std::string& text, std::size_t first_bytes, std::size_t step) {
    std::vector<std::size_t> bits;
    for (std::size_t bit = 0; bit < 8 * text.size(); bit += bit < 8 * first_bytes ? 3 : step)
        bits.push_back(bit);
    return bits;
}

} // namespace

TEST_CASE("what is committed comes back, after a kill and after a clean end") {
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

TEST_CASE("any flipped bit of a state file is seen, or nothing is stored there") {
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

TEST_CASE("a state file that is cut anywhere is refused") {
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

TEST_CASE("any flipped bit of what a kill leaves is seen, or nothing is stored there") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    Files files(killed);
    Everything whole(scratch / "state");
    int refused = 0, bits = 0;
    for (std::size_t bit : some_bits(files.log, 80, 10007)) {
        CAPTURE(bit);
        Files damaged = files;
        damaged.log = flipped(files.log, bit);
        refused += !accepted(damaged, whole);
        ++bits;
    }
    for (std::size_t bit : some_bits(files.mark, 0, 7)) {
        CAPTURE(bit);
        Files damaged = files;
        damaged.mark = flipped(files.mark, bit);
        CHECK_FALSE(accepted(damaged, whole));
    }
    CHECK(refused > bits - 80); // but for some of the log's heading
}

TEST_CASE("a log that is cut anywhere, or taken away, is refused, and so is a mark") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    Files files(killed);
    Everything whole(scratch / "state");
    std::size_t frame = 24 + 4096;
    for (std::size_t size = 0; size < files.log.size(); size += 1) {
        if ((size - 32) % frame != 0 && size % 9001 != 0)
            continue; // all ends of frames, and some others
        CAPTURE(size);
        Files cut = files;
        cut.log.resize(size);
        CHECK_FALSE(accepted(cut, whole));
    }
    for (std::size_t size = 0; size < files.mark.size(); ++size) {
        Files cut = files;
        cut.mark.resize(size);
        CHECK_FALSE(accepted(cut, whole));
    }
    CHECK(accepted(files, whole));
}

TEST_CASE("an older file in place of the newest is refused") {
    Scratch scratch, killed;
    write_and_kill(scratch, killed);
    Files old(killed);
    {
        StateContent content;
        StateFile file(killed / "state", "settings", most_history, content);
        std::vector<Parcel> parcels{parcel_of(61)};
        file.commit(parcels);
        Files now(killed);
        now.state = old.state;
        now.log = old.log;
        CHECK_FALSE(accepted(now, Everything(scratch / "state")));
    }
}

TEST_CASE("the last transaction may be spoilt when the power failed, before the mark was written, and is then said") {
    Scratch scratch, killed, before;
    {
        StateContent content;
        StateFile file(scratch / "state", "settings", most_history, content);
        for (int i = 1; i < 60; i += 2) {
            before.write("state-mark", scratch.read("state-mark"));
            std::vector<Parcel> parcels{parcel_of(i), parcel_of(i + 1)};
            file.commit(parcels);
        }
        for (const char* name : {"state", "state-wal"})
            killed.write(name, scratch.read(name));
    }
    killed.write("state-mark", before.read("state-mark"));
    std::string log = killed.read("state-wal");
    killed.write("state-wal", flipped(log, 8 * log.size() - 100));
    Everything everything(killed / "state");
    CHECK(everything.content.last_message == 58);
    CHECK(everything.content.said.find("the last transaction of") != std::string::npos);
}

TEST_CASE("a machine that is forgotten leaves nothing but its messages") {
    Scratch scratch;
    {
        StateContent content;
        StateFile file(scratch / "state", "settings", most_history, content);
        std::vector<Parcel> parcels{parcel_of(1), parcel_of(2), parcel_of(5), parcel_of(6)};
        parcels[2].entries[0] = KeptMessage{3, "a", "x"};
        parcels[3].entries[0] = KeptMessage{4, "b", "x"};
        file.commit(parcels);
        std::vector<Parcel> forget{{{KeptMessage{5, "a", forget_text}, ForgottenMachine{"a"}}}};
        file.commit(forget);
    }
    Everything everything(scratch / "state");
    CHECK(everything.content.machines.empty());
    CHECK(everything.content.messages.size() == 5);
    for (const KeptEstimate& each : everything.estimates)
        CHECK(each.machine == "b");
    CHECK(everything.alarms.size() == 1);
}

TEST_CASE("after a loss all begins anew, and alarms that went meanwhile are cleared") {
    Scratch scratch;
    StateContent content;
    StateFile file(scratch / "state", "settings", most_history, content);
    std::vector<Parcel> parcels{parcel_of(1)};
    parcels[0].entries.push_back(alarm("a", "leak", 1));
    file.commit(parcels);
    {
        FullDisk disk(scratch.read("state-wal").size());
        std::vector<Parcel> lost{parcel_of(2)};
        CHECK_THROWS_AS(file.commit(lost), store::DatabaseError);
    }
    Parcel anew{{OpenAlarms{{alarm("b", "drift", 3)}, 5}, KeptState{"b", 7, "s"}}, 7};
    file.commit(std::span(&anew, 1));
    CHECK(file.history().open_alarms() == std::vector<KeptAlarm>{alarm("b", "drift", 3)});
    CHECK(file.history().alarms("a", 10).at(0).cleared_at == 5);
    std::vector<Parcel> next{{{KeptMessage{8, "b", "x"}}}};
    file.commit(next);
}

TEST_CASE("a file that is removed again while it is made anew loses nothing of its history") {
    int removed_in_between = 0;
    for (int round = 0; round < 1000 && removed_in_between < 10; ++round) { // the remover may come too late
        Scratch scratch;
        StateContent content;
        StateFile file(scratch / "state", "settings", most_history, content);
        std::vector<Parcel> parcels{parcel_of(1)};
        file.commit(parcels);
        std::filesystem::remove(scratch / "state");
        CHECK_THROWS_AS(file.commit(parcels), store::DatabaseError);
        Parcel anew{{OpenAlarms{{}, 5}, KeptState{"b", 7, "s"}}, 7};
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

TEST_CASE("no state file: what it is instead, and what to do") {
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
    std::string away = fmt::format("; put a whole one there, or move it, {0}-wal and {0}-mark away and begin with "
                                   "nothing known",
                                   (scratch / "state").string());
    refused("", ("it is empty" + away).c_str());
    refused("rubbish", ("it is no state file of the monitor" + away).c_str());
    refused("{\"placedpar_monitor_state\":1,\"settings\":\"--seed 1\"",
            "it was written by an earlier placedpar monitor, as JSON, which this one does not read; use another "
            "--state file");
    refused("01234567 placedpar-monitor-journal 1 epoch 3\n",
            "it is the journal of an earlier placedpar monitor, which this one does not read; use another --state "
            "file");
    std::filesystem::remove(scratch / "state");
    scratch.write("state.journal", "");
    CHECK(refusal("state").find("state.journal is: the journal of an earlier placedpar monitor") != std::string::npos);
    scratch.write("state-wal", "");
    CHECK(refusal("state").find("what was written to it last is: ") != std::string::npos);
    std::filesystem::create_directory(scratch / "folder");
    CHECK(refusal("folder").find("it is a folder, no state file") != std::string::npos);
    std::filesystem::create_symlink(scratch / "nothing", scratch / "link");
    CHECK(refusal("link").find("a symbolic link to a file that is not there") != std::string::npos);
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
    refused("other", "settings", "it is a database of another program (its application_id is 0x00000000");
    {
        StateContent content;
        StateFile(scratch / "state", "settings", most_history, content);
    }
    refused("state", "others", "it was written with settings, this is others; use the same options");
    std::string text = scratch.read("state");
    text[63] = 9;
    scratch.write("state", text);
    refused("state", "settings", "it is of version 9, this program reads 2");
}

TEST_CASE("one at a time, by any of its names") {
    Scratch scratch;
    StateContent content;
    StateFile file(scratch / "state", "settings", most_history, content);
    std::filesystem::create_symlink(scratch / "state", scratch / "soft");
    std::filesystem::create_hard_link(scratch / "state", scratch / "hard");
    for (const char* name : {"state", "soft", "hard"})
        CHECK_THROWS_WITH_AS(StateFile(scratch / name, "settings", most_history, content),
                             doctest::Contains("another placedpar monitor is using it"), UserError);
}
