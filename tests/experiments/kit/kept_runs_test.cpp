#include "experiments/kit/kept_runs.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace placedpar;

namespace {

/// A name for a file that is gone at the end.
struct RunsFile {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "placedpar-kept-runs-test";
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
