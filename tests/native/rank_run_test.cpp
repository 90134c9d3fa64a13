// Tests native runs on ranks, which are threads of the test here. tests/app/native_ranks_test.py tests mpirun.

#include "native/rank_run.hpp"

#include "classics/kinds.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "ranks/expected_parcels.hpp"
#include "ranks/rank_mail.hpp"
#include "ranks/ranks.hpp"
#include "runtime/alternation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"
#include "tests/native/ring_of.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <csignal>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <numeric>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

/// Messages between ranks that are threads.
struct MadeUpWorld {
    struct Letter {
        int from;
        std::vector<std::uint8_t> bytes;
    };
    std::mutex mutex;
    std::vector<std::deque<Letter>> letters;
    std::vector<std::deque<RankParcel>> parcels; ///< by the receiving rank
    std::vector<std::deque<Ranks::Message>> texts;
    std::size_t parcels_sent = 0;
    std::function<void(std::vector<std::uint8_t>&)> damage = [](std::vector<std::uint8_t>&) {}; ///< of each letter

    explicit MadeUpWorld(int ranks)
        : letters(static_cast<std::size_t>(ranks)), parcels(letters.size()), texts(letters.size()) {}
};

class MadeUpMail final : public RankMail {
public:
    MadeUpMail(MadeUpWorld& world, int own) : world_(world), own_(own) {}
    int own() const override { return own_; }
    int count() const override { return static_cast<int>(world_.letters.size()); }
    int count_here() const override { return count(); }
    void send(int to, std::span<const std::uint8_t> letter) override {
        REQUIRE(letter.size() <= longest_letter);
        const std::lock_guard lock(world_.mutex);
        std::vector<std::uint8_t> bytes(letter.begin(), letter.end());
        world_.damage(bytes);
        world_.letters[static_cast<std::size_t>(to)].push_back({own_, std::move(bytes)});
    }
    std::optional<RankLetter> receive() override {
        const std::lock_guard lock(world_.mutex);
        auto& mine = world_.letters[static_cast<std::size_t>(own_)];
        if (mine.empty())
            return std::nullopt;
        letter_ = std::move(mine.front());
        mine.pop_front();
        return RankLetter{letter_.from, letter_.bytes};
    }
    void send_parcel(int to, int number, std::vector<std::uint8_t> bytes) override {
        const std::lock_guard lock(world_.mutex);
        ++world_.parcels_sent;
        world_.parcels[static_cast<std::size_t>(to)].push_back({own_, number, std::move(bytes)});
    }
    void expect_parcel(int from, int number, std::size_t bytes) override {
        expected_.add(from, number, bytes).request.looks = expected_ever_++ % 2 == 0 ? 20 : 0;
    }
    std::optional<RankParcel> receive_parcel() override {
        const std::lock_guard lock(world_.mutex);
        return expected_.take([this](auto& expected) { return has_come(expected.parcel, expected.request); });
    }
    bool has_all_parcels() const override { return expected_.empty(); }

private:
    /// A parcel that comes at a later look.
    struct Arriving {
        int looks = 0;         ///< how many are in vain
        bool is_taken = false; ///< the bytes have been matched
    };
    /// Matches parcels in the order in which they were sent, as MPI does. Every second one is complete long before the
    /// one before it.
    bool has_come(RankParcel& expected, Arriving& arriving) {
        auto& mine = world_.parcels[static_cast<std::size_t>(own_)];
        const auto sent = std::ranges::find_if(mine, [&](const RankParcel& each) {
            return each.from == expected.from && each.number == expected.number;
        });
        if (!arriving.is_taken && sent != mine.end()) {
            REQUIRE(sent->bytes.size() == expected.bytes.size());
            expected.bytes = std::move(sent->bytes);
            mine.erase(sent);
            arriving.is_taken = true;
        }
        return arriving.is_taken && arriving.looks-- <= 0;
    }

    MadeUpWorld& world_;
    int own_;
    MadeUpWorld::Letter letter_;
    ExpectedParcels<Arriving> expected_;
    int expected_ever_ = 0;
};

class MadeUpRanks final : public Ranks {
public:
    MadeUpRanks(MadeUpWorld& world, int own) : world_(world), own_(own) {}
    int own() const override { return own_; }
    int count() const override { return static_cast<int>(world_.texts.size()); }
    void send(int to, const std::string& text) override {
        const std::lock_guard lock(world_.mutex);
        world_.texts[static_cast<std::size_t>(to)].push_back({own_, text});
    }
    std::optional<Message> receive() override {
        const std::lock_guard lock(world_.mutex);
        auto& mine = world_.texts[static_cast<std::size_t>(own_)];
        if (mine.empty())
            return std::nullopt;
        Message first = std::move(mine.front());
        mine.pop_front();
        return first;
    }
    std::unique_ptr<RankMail> open_mail() override { return std::make_unique<MadeUpMail>(world_, own_); }

private:
    MadeUpWorld& world_;
    int own_;
};

Catalogue rank_kinds(const std::vector<ProcessKind>& own) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_classical_kinds(catalogue);
    for (const ProcessKind& kind : own)
        catalogue.add(ProcessKind(kind));
    return catalogue;
}

struct OnRanks {
    std::optional<RunReport> report;
    std::exception_ptr thrown;
    std::vector<std::string> notes;
    std::size_t parcels = 0;
    bool others_were_silent = true;
};

enum class Interrupted { none, last, all };

struct RankCase {
    Interrupted interrupted = Interrupted::none;
    bool sends_notes = false; ///< each rank above 0 sends two notes
    bool balances = false;    ///< places by loads, as an interrupted simulation gives them: each rank has others
    std::function<void(std::vector<std::uint8_t>&)> damage = [](std::vector<std::uint8_t>&) {};
};

/// Runs a netlist on ranks.
OnRanks on_ranks(int ranks, const std::string& text, const std::vector<ProcessKind>& own, const RankCase& how = {}) {
    MadeUpWorld world(ranks);
    world.damage = how.damage;
    OnRanks result;
    const auto run = [&](int rank) {
        const Catalogue catalogue = rank_kinds(own);
        ReadResult read = read_netlist_text(text, catalogue, {});
        REQUIRE_MESSAGE(read.network, render(read.diagnostics.front()));
        RankRunSettings settings;
        settings.make_catalogue = [&](const std::function<void(MessageBytes)>& send_note) {
            for (const auto number : {std::uint8_t{0}, std::uint8_t{1}})
                if (rank > 0 && how.sends_notes)
                    send_note({static_cast<std::uint8_t>(rank), number});
            return std::make_shared<const Catalogue>(rank_kinds(own));
        };
        settings.receive_note = [&](std::span<const std::uint8_t> note) {
            result.notes.emplace_back(note.begin(), note.end());
        };
        settings.is_interrupted = [&] {
            return how.interrupted == Interrupted::all ||
                   (how.interrupted == Interrupted::last && rank == ranks - 1);
        };
        if (how.balances)
            settings.loads = [&, rank] {
                std::vector<Time> loads(read.network->nodes.size(), Time(1));
                loads[static_cast<std::size_t>(rank)] = Time(5);
                return loads;
            };
        MadeUpRanks own_ranks(world, rank);
        return run_on_ranks(*read.network, settings, own_ranks);
    };
    std::vector<std::jthread> threads;
    for (int rank = 1; rank < ranks; ++rank)
        threads.emplace_back([&, rank] {
            if (run(rank))
                result.others_were_silent = false;
        });
    try {
        result.report = run(0);
    } catch (...) {
        result.thrown = std::current_exception();
    }
    threads.clear();
    result.parcels = world.parcels_sent;
    CHECK(result.others_were_silent);
    for (const auto& left : world.letters)
        CHECK(left.empty());
    for (const auto& left : world.parcels)
        CHECK(left.empty());
    return result;
}

std::string what_was_thrown(const OnRanks& result) {
    try {
        if (result.thrown)
            std::rethrow_exception(result.thrown);
    } catch (const std::exception& thrown) {
        return thrown.what();
    }
    return "";
}

template <class T = int>
ProcessKind rank_kind(const std::string& name, std::function<void(ProcessEnvironment&)> body) {
    ProcessKind kind;
    kind.name = name;
    kind.about = "Tests native runs on ranks.";
    kind.ports = {description::input<T>("in", "numbers", "numbers"),
                  description::output<T>("out", "numbers", "numbers")};
    kind.body = std::move(body);
    return kind;
}

} // namespace

TEST_CASE("a token goes round a ring, whatever the number of ranks") {
    constexpr int rounds = 300;
    const auto relay = rank_kind("relay", [](ProcessEnvironment& environment) { test::relay(environment, rounds); });
    for (const int ranks : {1, 2, 3, 5}) {
        const OnRanks run = on_ranks(ranks, test::ring_of(5, "relay"), {relay}, {.sends_notes = true});
        REQUIRE_MESSAGE(run.report, what_was_thrown(run));
        CHECK(run.report->result.ending == Ending::completed);
        CHECK(run.report->measured("p[0]", "token") == 5 * rounds);
        CHECK(run.report->measured("p[4]", "token") == 5 * rounds - 1);
        CHECK(run.report->processors.size() == static_cast<std::size_t>(ranks));
        CHECK(run.report->processors.back().name == fmt::format("rank {}", ranks - 1));
        CHECK(run.notes.size() == 2 * static_cast<std::size_t>(ranks - 1));
        for (std::size_t i = 0; i < run.notes.size(); ++i) // those of one rank are in order
            CHECK(std::ranges::count_if(run.notes.begin(), run.notes.begin() + static_cast<std::ptrdiff_t>(i),
                                        [&](const std::string& each) { return each[0] == run.notes[i][0]; }) ==
                  run.notes[i][1]);
    }
}

TEST_CASE("a deadlock over ranks is reported as that of a simulated run") {
    const auto sender = rank_kind("sender", [](ProcessEnvironment& environment) {
        environment.output<int>("out").output(1);
        environment.input<int>("in").input();
    });
    const Catalogue catalogue = rank_kinds({sender});
    const Network network = *read_netlist_text(test::ring_of(4, "sender"), catalogue, {}).network;
    const Deadlock simulated = *Machine(network, catalogue, 1).run().result.deadlock;
    for (const int ranks : {1, 2, 3, 4}) {
        const OnRanks run = on_ranks(ranks, test::ring_of(4, "sender"), {sender});
        REQUIRE(run.report);
        REQUIRE(run.report->result.ending == Ending::stuck);
        REQUIRE(run.report->result.deadlock);
        CHECK(run.report->result.deadlock->text() == simulated.text());
    }
}

TEST_CASE("a deadlock over ranks names partners that have ended, and components of PARs") {
    const auto both = rank_kind("both", [](ProcessEnvironment& environment) {
        par([&] { environment.input<int>("in").input(); }, [&] { wait_for(1ms); });
        environment.output<int>("out").output(1);
    });
    const OnRanks run = on_ranks(2, test::ring_of(2, "both"), {both});
    REQUIRE(run.report);
    REQUIRE(run.report->result.deadlock);
    CHECK(run.report->result.deadlock->cycle == std::vector<std::string>{"p[0]", "p[0]/0", "p[1]", "p[1]/0"});

    const auto early = rank_kind("early", [](ProcessEnvironment& environment) {
        if (environment.index() == 0)
            environment.input<int>("in").input();
    });
    const OnRanks ended = on_ranks(2, test::ring_of(2, "early"), {early});
    REQUIRE(ended.report->result.deadlock);
    CHECK(ended.report->result.deadlock->text().starts_with("no wait cycle: p[0] inputs for ever, but p[1] has ended"));
}

TEST_CASE("long messages are sent as parcels, and short ones are not") {
    const auto sends = [](std::size_t length) {
        return rank_kind<std::vector<double>>("sends", [length](ProcessEnvironment& environment) {
            if (environment.index() == 0) {
                std::vector<double> values(length);
                std::iota(values.begin(), values.end(), 1);
                for (int i = 0; i < 3; ++i)
                    environment.output<std::vector<double>>("out").output(values);
            } else {
                double sum = 0;
                for (int i = 0; i < 3; ++i) {
                    const auto values = environment.input<std::vector<double>>("in").input();
                    sum += std::accumulate(values.begin(), values.end(), 0.0);
                }
                environment.measure("sum", sum);
            }
        });
    };
    for (const std::size_t length : {0u, 1u, 400u, 500u, 5000u, 300000u}) {
        const OnRanks run = on_ranks(2, test::ring_of(2, "sends"), {sends(length)});
        REQUIRE(run.report);
        const auto n = static_cast<double>(length);
        CHECK(run.report->measured("p[1]", "sum") == 3 * n * (n + 1) / 2);
        CHECK(run.parcels == 1 + (length >= 500 ? 3 : 0)); // one is the result of rank 1
    }
}

TEST_CASE("an ALT leaves the message of a rank, long or short, until it is chosen") {
    for (const std::size_t length : {1u, 5000u}) {
        const auto alternates = rank_kind<std::vector<int>>("alternates", [length](ProcessEnvironment& environment) {
            if (environment.index() == 0) {
                environment.output<std::vector<int>>("out").output(std::vector<int>(length, 7));
                environment.measure("sent after ms", in_milliseconds(now()), "ms");
                return;
            }
            const auto in = environment.input<std::vector<int>>("in");
            Channel<std::vector<int>> local("local");
            int order = 0;
            par([&] { local.out().output({1}); },
                [&] {
                    wait_for(40ms); // both messages are there
                    alt(on(local.in(), [&](const std::vector<int>&) { order = 10; }),
                        on(in, [&](const std::vector<int>&) { order = 20; }));
                    wait_for(40ms);
                    order += in.input().back();
                });
            environment.measure("order", order);
        });
        const OnRanks run = on_ranks(2, test::ring_of(2, "alternates"), {alternates});
        REQUIRE_MESSAGE(run.report, what_was_thrown(run));
        CHECK(run.report->result.ending == Ending::completed);
        CHECK(run.report->measured("p[1]", "order") == 17);
        CHECK(run.report->measured("p[0]", "sent after ms") >= 75); // the outputter waited: the channel is synchronous
    }
}

TEST_CASE("a message that no process takes does not keep the run from its end") {
    for (const std::size_t length : {1u, 5000u}) {
        const auto ignores = rank_kind<std::vector<int>>("ignores", [length](ProcessEnvironment& environment) {
            if (environment.index() == 0)
                environment.output<std::vector<int>>("out").output(std::vector<int>(length, 7));
        });
        const OnRanks run = on_ranks(2, test::ring_of(2, "ignores"), {ignores});
        REQUIRE(run.report);
        CHECK(run.report->result.ending == Ending::stuck);
        CHECK(run.report->result.deadlock->channels.front().inputter == "p[1] (has ended)");
    }
}

TEST_CASE("what a process throws ends all ranks, and names the rank, the process and its place") {
    const auto failing = rank_kind("failing", [](ProcessEnvironment& environment) {
        if (environment.process() == "p[2]") {
            wait_for(5ms);
            throw UserError("there is no sand in this box");
        }
        environment.input<int>("in").input();
    });
    const std::string what = what_was_thrown(on_ranks(3, test::ring_of(3, "failing"), {failing}));
    CHECK(what.starts_with("rank 2: "));
    CHECK(what.find("process p[2] (failing) at ") != std::string::npos);
    CHECK(what.ends_with("there is no sand in this box"));
}

TEST_CASE("an interruption of ranks ends processes that compute, and that of one rank ends those that wait") {
    for (const bool all : {true, false}) {
        const auto busy = rank_kind("busy", [all](ProcessEnvironment& environment) {
            if (environment.index() == 0)
                for (;;)
                    all ? compute(Cycles{1}) : wait_for(1ms);
            environment.input<int>("in").input();
        });
        const OnRanks run = on_ranks(3, test::ring_of(3, "busy"), {busy},
                                     {.interrupted = all ? Interrupted::all : Interrupted::last});
        REQUIRE(run.report);
        CHECK(run.report->result.ending == Ending::interrupted);
        CHECK(run.report->result.time < Time(5s));
    }
}

TEST_CASE("processes on ranks wait for the end of the work again and again") {
    const auto again = rank_kind("again", [](ProcessEnvironment& environment) {
        if (environment.index() == 1) {
            int sum = 0;
            for (int i = 0; i < 3; ++i)
                sum += environment.input<int>("in").input();
            environment.measure("sum", sum);
        } else if (environment.index() == 0) {
            for (int i = 1; i <= 3; ++i) {
                wait_until_work_is_over();
                environment.output<int>("out").output(i);
            }
        }
    });
    for (const int ranks : {1, 2, 3}) {
        const OnRanks run = on_ranks(ranks, test::ring_of(3, "again"), {again});
        REQUIRE(run.report);
        CHECK(run.report->result.ending == Ending::completed);
        CHECK(run.report->measured("p[1]", "sum") == 6);
    }
}

TEST_CASE("an input from another rank can be given up, and an output cannot") {
    const auto hasty = rank_kind("hasty", [](ProcessEnvironment& environment) {
        if (environment.index() == 0) {
            wait_for(20ms);
            environment.output<int>("out").output(5);
            return;
        }
        const auto in = environment.input<int>("in");
        int given_up = 0, got = 0;
        while (!input_or_fail(in, got, now() + 2ms)) {
            ++given_up;
            reset(in);
        }
        environment.measure("given up", given_up);
        environment.measure("got", got);
    });
    const OnRanks run = on_ranks(2, test::ring_of(2, "hasty"), {hasty});
    REQUIRE_MESSAGE(run.report, what_was_thrown(run));
    CHECK(run.report->measured("p[1]", "got") == 5);
    CHECK(run.report->measured("p[1]", "given up") >= 1);

    const auto gives_up = rank_kind("gives_up", [](ProcessEnvironment& environment) {
        if (environment.index() == 0)
            output_or_fail(environment.output<int>("out"), 1, now() + 1ms);
    });
    CHECK(what_was_thrown(on_ranks(2, test::ring_of(2, "gives_up"), {gives_up}))
              .find("an output to another rank of mpirun cannot be given up") != std::string::npos);
}

namespace {

struct Unpackable {
    std::vector<int> numbers;
    WireForm wire_form() const { return WireForm(4u); }
};

} // namespace

TEST_CASE("messages that cannot be packed, and too many ranks, are refused before the run") {
    const auto odd = rank_kind<Unpackable>("odd", [](ProcessEnvironment&) { FAIL("the run has begun"); });
    const std::string what = what_was_thrown(on_ranks(2, test::ring_of(2, "odd"), {odd}));
    CHECK(what.find("the channel \"p[0].out -> p[1].in\" from the port \"out\" of kind \"odd\" leads to another rank, "
                    "but its messages cannot be packed") != std::string::npos);
    CHECK(what_was_thrown(on_ranks(3, test::ring_of(2, "csp.identity"), {})).find("start at most") !=
          std::string::npos);
}

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

TEST_CASE("an interruption while ranks find their loads ends all of them before the run") {
    const auto idle = rank_kind("idle", [](ProcessEnvironment&) {});
    CHECK(what_was_thrown(on_ranks(2, test::ring_of(2, "idle"), {idle},
                                   {.interrupted = Interrupted::all, .balances = true})) ==
          "interrupted before the run began");
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
        const auto relay = rank_kind("relay", [](ProcessEnvironment& environment) { test::relay(environment, 10); });
        on_ranks(2, test::ring_of(2, "relay"), {relay}, {.damage = damage});
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
        {[](Letter& letter) { letter.clear(); }, "received a damaged letter of 0 bytes from rank"},
        {[](Letter& letter) { letter[0] = 200; }, "its kind does not exist"},
        {[](Letter& letter) { letter[0] == of_a_process ? letter.resize(3) : void(); },
         "damaged letter of 3 bytes from rank"},
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
    const auto relay = rank_kind("relay", [](ProcessEnvironment& environment) { test::relay(environment, 10); });
    const auto cut = [](Letter& letter) { letter[0] == of_a_process ? letter.resize(7) : void(); };
    const std::string what =
        what_was_thrown(on_ranks(2, test::ring_of(2, "relay"), {relay}, {.damage = cut}));
    CHECK_MESSAGE(what.find("a message that is cut off") != std::string::npos, what);
    CHECK_MESSAGE(what.find("process p[") != std::string::npos, what);
}
