#pragma once

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_observer.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

class SearchProgress; // gaprocs/search_progress.hpp

/// The settings of several islands, that is, searches that exchange individuals. By default they form a ring: after
/// every third generation the best individual of each island replaces the worst individual of the next island.
struct IslandsSettings {
    /// The settings of each island. All islands must make the same number of generations (WindowSettings::trials) after
    /// each sample of measurements.
    std::vector<SearchSettings> islands;
    Topology topology;
    Schedule schedule;
    Emigration emigration;
    Acceptance acceptance;

    /// Throws the UserErrors of SearchSettings::validate(), WindowSettings::validate_for(), Topology::neighbours(),
    /// Emigration::validate_for() and Acceptance::validate_for(). Throws a UserError also if a number of a policy (such
    /// as the topology or the schedule) is out of range, or if islands make different numbers of generations per
    /// sample.
    void validate_for(std::size_t record_length) const;
    /// Returns a warning about a topology that is allowed, but probably not intended; otherwise "". In such a topology
    /// the islands form several parts that exchange nothing with each other, or individuals of some island never reach
    /// some other island of its part. Throws what Topology::neighbours() throws.
    std::string warning() const;
};

/// An individual that moves from one island to another.
struct Migration {
    std::uint64_t generation; ///< number of the generation after which the individual leaves, from 1
    std::size_t from, to;
    /// The string of the individual, with its fitness in the window of the new island. With OffspringAcceptance, the
    /// fitness is for the window of the old island, because the new island evaluates the individual one generation
    /// later.
    Individual individual;
    std::optional<std::size_t> place; ///< index of the replaced individual; nothing if the immigrant is rejected

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// Accepts the immigrants in the given order, sets Migration::place of each, and breeds the next generation. Throws
/// what Search::accept() and Search::next_generation() throw. REQUIRES: unless Acceptance::among_offspring(), each
/// immigrant's fitness was computed in this island's window.
void accept_and_breed(Search&, std::span<double> fitness, std::span<Migration> arrivals, const Acceptance&);

/// Runs several searches (islands) over the same record of measurements, without simulating the machine that they run
/// on. In each generation, first all islands are evaluated and their emigrants chosen; then each island accepts its
/// immigrants and breeds. An island accepts immigrants in the order of the numbers of the islands from which they come.
/// The result does not depend on the order in which the islands are computed, because each island draws from its own
/// random stream. Unless the schedule is asynchronous, islands that exchange with each other, directly or through other
/// islands, begin together, when each of them has enough samples for a generation.
///
/// An island's window is the newest samples, over which it evaluates individuals. An immigrant is evaluated again in
/// the window of its new island. If both islands have the same window, the fitness does not change, because sums of
/// fitness are exact (gaprocs/fitness.hpp). With OffspringAcceptance, immigrants are evaluated one generation later.
///
/// With the asynchronous schedule, no island waits for another. Because this class has no simulated time, the islands
/// take turns in each generation, island 0 first. In its turn an island evaluates, sends emigrants, accepts the
/// immigrants sent so far, and breeds.
class Islands {
public:
    /// `streams`: one random stream for each island. REQUIRES: `problem` outlives the islands. Throws what
    /// settings_for() and IslandsSettings::validate_for() throw, but does not compare the windows with the length of
    /// the record. Throws std::invalid_argument if the number of streams differs from the number of islands.
    Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams);

    /// Reports all further generations and migrations to the observer. The islands have the names of island_names().
    /// REQUIRES: the observer outlives the islands.
    void observe_by(SearchObserver& observer);

    /// Continues from the checkpoints, and stores new checkpoints. The islands have the names of island_names(). Throws
    /// what the constructor of SearchProgress throws. REQUIRES: called before the first next_generation(); the
    /// checkpoints outlive the islands.
    void keep_by(Checkpoints& checkpoints);

    void push(const Sample& sample);
    /// Returns whether this island, and all islands that begin together with it, have enough samples for a generation.
    bool ready(std::size_t island) const;
    bool ready() const;
    /// Makes one generation of each island that is ready. Skips a generation that an earlier run, from whose checkpoint
    /// this run continues, has already made.
    void next_generation();
    /// Returns whether the last next_generation() made a generation of this island.
    bool has_made(std::size_t island) const { return made_[island]; }
    /// Returns the progress of each island; empty without checkpoints.
    const std::vector<std::shared_ptr<SearchProgress>>& progress() const { return progress_; }

    const std::vector<Search>& searches() const { return searches_; }
    /// Returns the migrations of the last next_generation(), sorted by destination. Migrations to the same island are
    /// in the order in which the immigrants were accepted or rejected.
    const std::vector<Migration>& migrations() const { return migrations_; }

private:
    void choose_islands();
    void exchange_in_step();
    void evaluate_one(std::size_t island);
    std::vector<Migration> emigrants(std::size_t from);
    void send_by_mail(std::size_t from);
    std::vector<Migration> mail_for(std::size_t island);
    void breed(std::size_t island, std::span<Migration> arrivals);
    void tell_migrations(std::size_t to, std::span<const Migration> arrivals) const;

    const SearchProblem& problem_;
    IslandsSettings settings_;
    Neighbours neighbours_;
    /// For each island, the islands that begin together with it, including itself.
    std::vector<std::vector<std::size_t>> in_step_;
    std::vector<SlidingWindow> windows_;
    std::vector<Search> searches_;
    std::vector<std::vector<double>> fitness_; ///< fitness_[island][individual] in the current generation
    std::vector<Migration> migrations_;
    /// For the asynchronous schedule: emigrants that have been sent but not yet received; mail_[to][from] goes from
    /// island `from` to island `to`.
    std::vector<std::map<std::size_t, std::vector<Migration>>> mail_;
    std::vector<char> made_; ///< see has_made()
    std::vector<std::shared_ptr<SearchProgress>> progress_;
    SearchObserver* observer_ = nullptr;
    std::vector<std::string> names_; ///< names of the islands for the observer
};

struct IslandsResult {
    std::vector<SearchResult> islands;
    std::vector<Migration> migrations; ///< migrations of all generations, in the order of the generations
};

/// Runs the islands over a record, without a simulated machine. The islands continue from checkpoints as
/// run_traditional() does. Unless the schedule is asynchronous, the generations then equal the generations of an
/// unbroken run, bit for bit. Throws what Islands, IslandsSettings::validate_for(), require_channels() and
/// SearchProgress throw.
IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr,
                          Checkpoints* checkpoints = nullptr);
/// Runs the islands on a problem with an objective, which needs no measurements. Each island gives one estimate for
/// each generation.
IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr,
                          Checkpoints* checkpoints = nullptr);

/// Returns "island[0]", "island[1]", ..., the names of processes that a netlist declares as island[n].
std::vector<std::string> island_names(std::size_t islands);
/// Returns the random streams of a run, one for each island, keyed by `seed` and the names of island_names().
std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands);

} // namespace placedpar
