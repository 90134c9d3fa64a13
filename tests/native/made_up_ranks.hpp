#pragma once

#include "native/native_trace.hpp"
#include "native/rank_run.hpp"

#include "classics/kinds.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/read.hpp"
#include "ranks/expected_parcels.hpp"
#include "ranks/rank_mail.hpp"
#include "ranks/ranks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace placedpar::test {

/// Messages between ranks that are threads.
struct MadeUpWorld {
    struct Letter {
        int from;
        std::vector<std::uint8_t> bytes;
    };
    std::mutex mutex;
    std::vector<std::deque<Letter>> letters;
    std::vector<std::deque<RankParcel>> parcels; ///< at the index of the receiving rank
    std::vector<std::deque<Ranks::Message>> texts;
    std::size_t parcels_sent = 0;
    NativeTrace* trace = nullptr;                                                               ///< records the run
    std::function<void(std::vector<std::uint8_t>&)> damage = [](std::vector<std::uint8_t>&) {}; ///< damages a letter

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
    /// The state of a parcel that arrives only after some checks.
    struct Arriving {
        int looks = 0;         ///< number of checks before the parcel arrives
        bool is_taken = false; ///< the bytes have been matched
    };
    /// Matches parcels in the order in which they were sent, as MPI does. Every second parcel is complete long before
    /// the parcel that was sent before it.
    bool has_come(RankParcel& expected, Arriving& arriving) {
        auto& mine = world_.parcels[static_cast<std::size_t>(own_)];
        const auto sent = std::ranges::find_if(
            mine, [&](const RankParcel& each) { return each.from == expected.from && each.number == expected.number; });
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

inline Catalogue rank_kinds(const std::vector<ProcessKind>& own) {
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
    bool sends_notes = false;     ///< each rank above 0 sends two notes
    bool balances = false;        ///< whether processes are placed by loads, which differ from rank to rank as after an
                                  ///< interrupted simulation
    NativeTrace* trace = nullptr; ///< records the run
    std::function<void(std::vector<std::uint8_t>&)> damage = [](std::vector<std::uint8_t>&) {};
};

/// Runs a netlist on ranks.
inline OnRanks on_ranks(int ranks, const std::string& text, const std::vector<ProcessKind>& own,
                        const RankCase& how = {}) {
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
            return how.interrupted == Interrupted::all || (how.interrupted == Interrupted::last && rank == ranks - 1);
        };
        if (how.balances)
            settings.loads = [&, rank] {
                std::vector<Time> loads(read.network->nodes.size(), Time(1));
                loads[static_cast<std::size_t>(rank)] = Time(5);
                return loads;
            };
        NativeTrace other;
        if (how.trace)
            settings.trace = rank == 0 ? how.trace : &other;
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

inline std::string what_was_thrown(const OnRanks& result) {
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

} // namespace placedpar::test
