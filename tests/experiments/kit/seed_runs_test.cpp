// Tests that runs of many seeds are made in parallel, and stored in a file that is either read exactly or refused.

#include "experiments/kit/experiment_runs.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "explore/netlist_run.hpp"
#include "explore/study/results.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

using namespace placedpar;

namespace {

StudySource source_named(const std::string& replay) { return {replay, {}, replay, ""}; }

/// A file in its own folder; both are deleted at the end.
class RunsFile {
public:
    RunsFile() { std::filesystem::create_directory(folder_); }
    ~RunsFile() { std::filesystem::remove_all(folder_); }
    RunsFile(const RunsFile&) = delete;
    RunsFile& operator=(const RunsFile&) = delete;

    StudyResults open(const std::string& replay = "mine") const { return StudyResults(path(), source_named(replay)); }
    std::filesystem::path path() const { return folder_ / "kept"; }
    std::string bytes() const {
        std::ifstream in(path(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::string& bytes) const { std::ofstream(path(), std::ios::binary) << bytes; }

private:
    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / fmt::format("placedpar-seed-runs-{}", ::getpid());
};

/// A replay with this many seeds that counts its runs.
struct SmallReplay {
    Interruption interruption;
    std::atomic<int> made = 0;

    std::vector<Figures> run(std::size_t seeds, StudyResults& results, const std::string& what = "a, b") {
        return run_seeds(context(seeds, results), what, [&](std::uint64_t seed) {
            ++made;
            return Figures{static_cast<double>(seed % 1000), 1.0 / 3, -0.0, HUGE_VAL};
        });
    }
    ReplayContext context(std::size_t seeds, StudyResults& results) {
        return {{}, 1, [](const std::string&) {}, [](const std::string&) {}, interruption, results, seeds};
    }
};

} // namespace

TEST_CASE("figures are in the order of the seeds, exact to the last bit") {
    SmallReplay replay;
    StudyResults results(source_named("mine"));
    std::vector<Figures> runs = replay.run(9, results);
    Seeds seeds = seeds_of(replay.context(9, results));
    for (std::size_t i = 0; i < seeds.size(); ++i)
        CHECK(runs[i] == Figures{static_cast<double>(seeds[i] % 1000), 1.0 / 3, 0, HUGE_VAL});
    CHECK(std::signbit(runs[0][2]));
    CHECK(replay.made == 9);
}

TEST_CASE("runs in the file are not repeated") {
    RunsFile file;
    SmallReplay replay;
    std::vector<Figures> first, more;
    {
        StudyResults kept = file.open();
        first = replay.run(5, kept);
    }
    StudyResults kept = file.open();
    CHECK(replay.run(9, kept).at(4) == first.at(4));
    CHECK(replay.made == 9);
    replay.run(9, kept, "another");
    CHECK(replay.made == 18);
}

TEST_CASE("an exception of a run ends the experiment, and finished runs are kept") {
    RunsFile file;
    SmallReplay replay;
    StudyResults kept = file.open();
    replay.run(3, kept);
    auto fails = [](std::uint64_t) -> Figures { throw std::runtime_error("no more ink"); };
    CHECK_THROWS_WITH(run_seeds(replay.context(5, kept), "a, b", fails), "no more ink");
    CHECK(kept.count() == 3);
}

TEST_CASE("an interrupted replay keeps the runs that ended") {
    RunsFile file;
    SmallReplay replay;
    StudyResults kept = file.open();
    std::atomic<int> told = 0; // reports of progress since the interruption; at the second, all workers have stopped
    ReplayContext context = replay.context(1000, kept);
    context.progress = [&](const std::string&) { told += replay.interruption.requested(); };
    auto interrupts = [&](std::uint64_t) {
        replay.interruption.request();
        while (told < 2)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return Figures{1};
    };
    CHECK_THROWS_AS(run_seeds(context, "a, b", interrupts), UnfinishedRun);
    CHECK(kept.count() > 0);
    CHECK(kept.count() < 1000);
}

TEST_CASE("a file of another replay or version, or a damaged one, is refused and not changed") {
    RunsFile file;
    SmallReplay replay;
    {
        StudyResults kept = file.open();
        replay.run(5, kept);
    }
    const std::string good = file.bytes();
    auto refused = [&](const std::string& bytes, const char* whose, const char* why) {
        file.write(bytes);
        CHECK_THROWS_WITH_AS(file.open(whose), doctest::Contains(why), UserError);
        CHECK(file.bytes() == bytes);
    };
    refused(good, "yours", "with other options (mine, not yours); name another file, or move this file away");
    refused("checked runs of mine\na\t1\t0.5\t0123456789abcdef\n", "mine", "name another file");
    std::string damaged = good;
    damaged[damaged.find("E0,\"\"")] ^= 1;
    refused(damaged, "mine", "the file is damaged (row ");
    refused(good.substr(0, good.size() / 2), "mine", "malformed): name another file, or move this file away");
    file.write(good);
    CHECK(file.open().count() == 5);
}

TEST_CASE("progress names the runs and includes those of the file") {
    SmallReplay replay;
    StudyResults results(source_named("mine"));
    replay.run(2, results);
    ReplayContext context = replay.context(5, results);
    std::string first;
    context.progress = [&](const std::string& told) { first = first.empty() ? told : first; };
    run_seeds(context, "a, b", [](std::uint64_t) { return Figures{0}; });
    CHECK(first == "a, b: 2 of 5 seeds");
}

TEST_CASE("a column is one figure of each run") {
    CHECK(column({{1, 2, 3}, {4, 5, 6}}, 1) == std::vector<double>{2, 5});
    CHECK(column({}, 0).empty());
}
