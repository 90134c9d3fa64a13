#include "experiments/kit/kept_runs.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

using namespace placedpar;

namespace {

/// A name for a file that is gone at the end.
struct RunsFile {
    static constexpr const char* memory = "/dev/shm"; // quicker than a disk
    std::filesystem::path path = (std::filesystem::is_directory(memory) ? std::filesystem::path(memory)
                                                                        : std::filesystem::temp_directory_path()) /
                                 "placedpar-kept-runs-test";
    RunsFile() { std::filesystem::remove(path); }
    ~RunsFile() { std::filesystem::remove(path); }

    std::string text() const {
        std::ostringstream out;
        out << std::ifstream(path).rdbuf();
        return out.str();
    }
};

struct NeverInterrupted {
    Interruption interruption;
    ReplayContext context(std::size_t seeds, KeptRuns* kept) {
        return {{}, 1, [](const std::string&) {}, [](const std::string&) {}, interruption, seeds, kept};
    }
};

} // namespace

TEST_CASE("runs come back to the last bit, and a line that was cut off is made again") {
    RunsFile file;
    {
        KeptRuns kept(file.path, "mine");
        kept.add("a, b", 7, {1.0 / 3, -0.0, 1e300});
        kept.add("a, b", 8, {2});
    }
    std::filesystem::resize_file(file.path, std::filesystem::file_size(file.path) - 2);
    KeptRuns kept(file.path, "mine");
    CHECK(kept.find("a, b", 7) == Figures{1.0 / 3, -0.0, 1e300});
    CHECK_FALSE(kept.find("a, b", 8));
    CHECK_FALSE(kept.find("a", 7));
    kept.add("a, b", 9, {3});
    CHECK(KeptRuns(file.path, "mine").find("a, b", 9) == Figures{3});
}

TEST_CASE("with any bit of it flipped, or cut off anywhere, kept runs are the same, fewer, or refused") {
    RunsFile file;
    {
        KeptRuns kept(file.path, "mine");
        kept.add("a, b", 7, {1.0 / 3, -0.0, 1e300});
        kept.add("a, b", 8, {2, std::numeric_limits<double>::infinity()});
        kept.add("c", 18446744073709551615u, {});
    }
    const std::string good = file.text();
    int refused = 0;
    auto check = [&](const std::string& damaged) {
        CAPTURE(damaged);
        std::ofstream(file.path, std::ios::binary) << damaged;
        try {
            KeptRuns kept(file.path, "mine");
            CHECK(kept.find("a, b", 7).value_or(Figures{1.0 / 3, -0.0, 1e300}) == Figures{1.0 / 3, -0.0, 1e300});
            CHECK(std::signbit(kept.find("a, b", 7).value_or(Figures{0, -0.0}).at(1)));
            CHECK(kept.find("a, b", 8).value_or(Figures{2, HUGE_VAL}) == Figures{2, HUGE_VAL});
            CHECK(kept.find("c", 18446744073709551615u).value_or(Figures{}).empty());
            CHECK(good.starts_with(file.text())); // nothing else is kept
        } catch (const UserError&) {
            ++refused;
            CHECK(file.text() == damaged);
        }
    };
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        std::string damaged = good;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
        check(damaged);
    }
    CHECK(refused == 8 * static_cast<int>(good.size()) - 8); // but for the last end of a line: that line has none then
    for (std::size_t size = 0; size < good.size(); ++size)
        check(good.substr(0, size));
}

TEST_CASE("kept runs in another notation, twice, of another file or without checksums are refused") {
    RunsFile file;
    {
        KeptRuns kept(file.path, "mine");
        kept.add("a", 1, {0.5});
    }
    const std::string good = file.text(), line = good.substr(good.find('\n') + 1);
    auto refused = [&](const std::string& text, const std::string& why) {
        CAPTURE(text);
        std::ofstream(file.path, std::ios::binary) << text;
        CHECK_THROWS_WITH_AS(KeptRuns(file.path, "mine"), doctest::Contains(why.c_str()), UserError);
    };
    refused(good + line, "line 3 is damaged: without it, its run is made again");
    refused("checked runs of mine\na\t1\t0.50\t" + line.substr(line.rfind('\t') + 1), "line 2 is damaged");
    refused("checked runs of mine\na\t1\n", "line 2 is damaged");
    refused("checked runs of mine\n\n", "line 2 is damaged");
    refused("runs of mine\na\t1\t0x1p-1\n", "kept by an earlier PlacedPar, without checksums");
    std::filesystem::remove(file.path);
    KeptRuns(file.path, "yours").add("a", 1, {0.5});
    std::string theirs = file.text();
    refused("checked runs of mine\n" + theirs.substr(theirs.find('\n') + 1), "line 2 is damaged");
}

TEST_CASE("a file of another experiment is refused and stays as it is") {
    RunsFile file;
    KeptRuns(file.path, "mine").add("a", 1, {1});
    std::string before = file.text();
    CHECK_THROWS_WITH_AS(KeptRuns(file.path, "yours"), doctest::Contains("name another file"), UserError);
    CHECK(file.text() == before);
}

TEST_CASE("runs of many threads come in the order of the seeds; what is kept is not run again") {
    RunsFile file;
    NeverInterrupted never;
    std::atomic<int> made = 0;
    auto run = [&](std::uint64_t seed) {
        ++made;
        return Figures{static_cast<double>(seed % 1000)};
    };
    KeptRuns kept(file.path, "mine");
    auto first = run_seeds(never.context(5, &kept), "what", run);
    CHECK(made == 5);
    auto more = run_seeds(never.context(9, &kept), "what", run);
    CHECK(made == 9);
    Seeds seeds = seeds_of(never.context(9, nullptr));
    for (std::size_t i = 0; i < seeds.size(); ++i)
        CHECK(column(more, 0)[i] == static_cast<double>(seeds[i] % 1000));
    CHECK(std::vector(more.begin(), more.begin() + 5) == first);
    CHECK(run_seeds(never.context(9, nullptr), "what", run) == more);
}

TEST_CASE("what a run throws ends the experiment") {
    NeverInterrupted never;
    auto run = [](std::uint64_t) -> Figures { throw std::runtime_error("no more ink"); };
    CHECK_THROWS_WITH(run_seeds(never.context(3, nullptr), "what", run), "no more ink");
}
