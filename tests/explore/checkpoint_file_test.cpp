// Tests the file from which searches continue: what is read back, when it is written, and which files are refused.

#include "explore/checkpoint_file.hpp"

#include "explore/load.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "report/manifest.hpp"
#include "tests/scratch.hpp"
#include "text/checksum.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A state with numbers that a decimal text could lose.
SearchCheckpoint odd_state(std::uint64_t generation) {
    SearchCheckpoint state;
    state.search.generation = generation;
    state.search.redraws = 2;
    state.search.drawn = std::numeric_limits<std::uint64_t>::max();
    state.search.population = {Genome::from_string("0110"), Genome::from_string("1111")};
    state.search.best = Individual{Genome::from_string("0110"), 0.1 + 0.2};
    state.populations = 0x8000000000000001;
    state.best = {Genome::from_string("1111"), -std::numeric_limits<double>::denorm_min()};
    state.improvements = {{1, -0.1 - 0.2}, {4, state.best.fitness}};
    return state;
}

const std::vector<KeptSearch> two_searches{{"a", {{"population", "2"}}}, {"b", {{"population", "2"}}}};

CheckpointFile checkpoint_at(const std::filesystem::path& path, std::uint64_t seed = 1, std::uint64_t every = 10) {
    return {path, two_searches, seed, every};
}

/// Writes a checkpoint of both searches at generation 10.
std::filesystem::path written_checkpoint(const Scratch& folder) {
    const auto path = folder / "search.checkpoint";
    CheckpointFile file(path, two_searches, 1, 10);
    file.keep("a", odd_state(10));
    file.keep("b", odd_state(10));
    return path;
}

std::string with_change(std::string text, const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), with);
}

/// Returns the file with the right checksum of its contents.
std::string sealed(const std::string& text) {
    boost::json::object file = boost::json::parse(text).as_object();
    file.stable_erase(file.find("checksum"));
    const std::string checksum = hex(static_cast<std::uint64_t>(checksum_of(boost::json::serialize(file))));
    file["checksum"] = checksum;
    return boost::json::serialize(file);
}

} // namespace

TEST_CASE("without a file the searches begin anew") {
    const Scratch folder;
    const CheckpointFile file(folder / "new", two_searches, 1, 10);
    CHECK(file.begin() == 0);
    CHECK(file.begin_of("a") == nullptr);
    CHECK_FALSE(std::filesystem::exists(folder / "new"));
}

TEST_CASE("states are read back to the last bit") {
    const Scratch folder;
    const CheckpointFile file(written_checkpoint(folder), two_searches, 1, 10);
    CHECK(file.begin() == 10);
    for (const char* search : {"a", "b"}) {
        REQUIRE(file.begin_of(search));
        CHECK(*file.begin_of(search) == odd_state(10));
    }
    CHECK(file.begin_of("c") == nullptr);
}

TEST_CASE("states are due after each so many generations") {
    const Scratch folder;
    const CheckpointFile file(folder / "new", two_searches, 1, 10);
    CHECK(file.is_due(10));
    CHECK(file.is_due(20));
    CHECK_FALSE(file.is_due(11));
}

TEST_CASE("the file is written when the last search has reached a generation, and has the latest such generation") {
    const Scratch folder;
    const auto path = folder / "search.checkpoint";
    CheckpointFile file(path, two_searches, 1, 10);
    file.keep("a", odd_state(10));
    file.keep("a", odd_state(20));
    CHECK_FALSE(std::filesystem::exists(path));
    file.keep("b", odd_state(10));
    CHECK(checkpoint_at(path).begin() == 10);
    file.keep("b", odd_state(20));
    CHECK(checkpoint_at(path).begin() == 20);
}

TEST_CASE("a file of another seed, or of other searches, is refused with the difference") {
    const Scratch folder;
    const auto path = written_checkpoint(folder);
    const auto refused = [&](const std::vector<KeptSearch>& searches, std::uint64_t seed, const std::string& why) {
        CHECK_THROWS_WITH_AS((CheckpointFile{path, searches, seed, 10}),
                             (path.string() + ": the checkpoint has " + why +
                              ": give the file of a matching checkpoint, or delete this file to begin anew")
                                 .c_str(),
                             UserError);
    };
    refused(two_searches, 2, "seed 1, but this run has 2");
    refused({two_searches[0]}, 1, "search count 2, but this run has 1");
    refused({two_searches[0], {"c", {}}}, 1, "a search named b, but this run has c");
    refused({two_searches[0], {"b", {{"population", "3"}}}}, 1, "b.population = 2, but this run has 3");
    CHECK_NOTHROW(CheckpointFile(path, two_searches, 1, 3)); // the number of generations between states may change
}

TEST_CASE("damaged files are refused, and nothing is read beyond them") {
    const Scratch folder;
    const std::string whole = folder.read(written_checkpoint(folder).filename().string());
    std::vector<std::string> damaged{"", "{", "[]", "{}", "null", "\xff\xfe", whole + "x"};
    damaged.push_back(whole.substr(0, whole.size() / 2));
    damaged.push_back(sealed(with_change(whole, "\"generation\": 10", "\"generation\": 0")));
    damaged.push_back(sealed(with_change(whole, "\"generation\": 10", "\"generation\": -1")));
    damaged.push_back(sealed(with_change(whole, "\"generation\": 4", "\"generation\": 1")));
    damaged.push_back(sealed(with_change(whole, "\"generation\": 4", "\"generation\": 11")));
    damaged.push_back(sealed(with_change(whole, "0110", "01x0")));
    damaged.push_back(sealed(with_change(whole, "\"redraws\": 2", "\"redraws\": \"2\"")));
    damaged.push_back(sealed(with_change(whole, "fitness_bits", "fitness")));
    for (const std::string& text : damaged) {
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(checkpoint_at(folder.write("damaged", text)),
                             doctest::Contains("this is not a checkpoint of a search ("), UserError);
    }
}

TEST_CASE("a file with a flipped bit is refused, or has the same states") {
    const Scratch folder;
    const std::string whole = folder.read(written_checkpoint(folder).filename().string());
    CHECK(checkpoint_at(folder.write("sealed", sealed(whole))).begin() == 10);
    std::size_t read = 0;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
        const auto path = folder.write("flipped", flipped);
        try {
            const CheckpointFile file = checkpoint_at(path);
            CHECK(*file.begin_of("a") == odd_state(10));
            CHECK(*file.begin_of("b") == odd_state(10));
            ++read;
        } catch (const UserError&) {
        }
    }
    CHECK(read < whole.size()); // only bits of blanks
}

TEST_CASE("a checkpoint of another version is refused with both formats") {
    const Scratch folder;
    const std::string whole = folder.read(written_checkpoint(folder).filename().string());
    CHECK_THROWS_WITH_AS(
        checkpoint_at(folder.write("old", with_change(whole, "checkpoint 3", "checkpoint 2"))),
        doctest::Contains(
            "another version of PlacedPar wrote this checkpoint, in the format \"checkpoint 2\" (expected "
            "\"checkpoint 3\"): "),
        UserError);
}

TEST_CASE("the name of a folder, and standard input, are not names of a checkpoint") {
    const Scratch folder;
    for (const std::filesystem::path& path : {std::filesystem::path("-"), folder / "."})
        CHECK_THROWS_WITH_AS(checkpoint_at(path), doctest::Contains("give the name of a file"), UserError);
    CHECK_THROWS_AS(checkpoint_at(folder / "none" / "file"), UserError);
}

TEST_CASE("two files have the same digest only if the searches continue from the same states") {
    const Scratch folder, other;
    const auto path = written_checkpoint(folder);
    CHECK(checkpoint_at(path).digest() == checkpoint_at(path).digest());
    CHECK(checkpoint_at(path).digest() == checkpoint_at(written_checkpoint(other)).digest());
    CHECK(checkpoint_at(path).digest() != checkpoint_at(path, 1, 5).digest());
    CHECK(checkpoint_at(path).digest() != checkpoint_at(folder / "new").digest());
}

TEST_CASE("a search that continues from its file makes the generations of an unbroken search") {
    const Scratch folder;
    const ProblemRegistry problems = known_problems(1);
    const Network network = load_network(PLACEDPAR_SOURCE_DIR "/examples/thesis/table-e1/cluster.cfs",
                                         {{"slaves", "1"}}, problems, [](const std::string&) {});
    const auto hash_after = [&](Checkpoints* checkpoints) {
        return run_netlist(network, problems, {.seed = 1, .checkpoints = checkpoints})
            .measured("master", "best_fitness");
    };
    CheckpointFile first(folder / "c", network, 1, 7);
    const double unbroken = hash_after(nullptr);
    CHECK(hash_after(&first) == unbroken);
    CheckpointFile second(folder / "c", network, 1, 7);
    CHECK(second.begin() > 0);
    CHECK(second.begin() % 7 == 0);
    CHECK(hash_after(&second) == unbroken);
}

TEST_CASE("a network without a search has no checkpoint") {
    const Scratch folder;
    const Network network = load_network(PLACEDPAR_SOURCE_DIR "/examples/csp/matrix/matrix.cfs", {}, known_problems(1),
                                         [](const std::string&) {});
    CHECK_THROWS_AS(CheckpointFile(folder / "c", network, 1, 10), UserError);
}
