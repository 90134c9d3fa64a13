#pragma once

#include "explore/study/measure.hpp"
#include "explore/study/study.hpp"
#include "store/database.hpp"
#include "store/file_lock.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// What came of a run.
struct StudyOutcome {
    std::string ended; ///< "completed", "deadlock", "stopped at the time limit", "refused"
    Time time{};
    std::uint64_t fingerprint = 0;
    std::uint64_t netlist_hash = 0;
    std::string refused = ""; ///< printed reason why the machine is refused; "" if it is not
    StudyFigures figures = {};
};

/// What all runs of a file have in common. Files of another one are refused. Those of functions have no texts.
struct StudySource {
    std::string netlist;                                    ///< its path as it was given; may be another
    std::vector<std::pair<std::string, std::string>> texts; ///< path and text of the netlist and what it includes
    std::string
        options; ///< JSON: what else decides a run: programs, faults, where it is stopped; of functions, whose they are
    std::string named_by = " with --results"; ///< how another file is named, as a refusal says it

    /// Whatever its files are called.
    bool operator==(const StudySource& other) const;
};
/// Reads the netlist's files. `network` is one that was read from them. Throws UserError.
StudySource source_of(const Study&, const Network& network);

/// The runs of studies of one netlist, in a file of SQLite: a row a run, with all that is needed to make it again. What
/// has been kept outlives the program, however that ends. Each row has a checksum, and their number and the sum of
/// these are kept, so that a file is read only if it is what was written. Functions throw UserError with the file's
/// name.
class StudyResults {
public:
    /// Opens a file to add runs, or makes it. Refuses one of another netlist, of other options, of a later format, and,
    /// unless told otherwise, of another version of PlacedPar; and one that another program adds to.
    StudyResults(const std::filesystem::path&, const StudySource&, bool of_any_version = false);
    /// Opens a file to read it, also while another program adds to it: it stays as it is now.
    explicit StudyResults(const std::filesystem::path&);
    /// Has them in memory: they go with it.
    explicit StudyResults(const StudySource&);
    ~StudyResults();

    bool has(const StudyRun&);
    std::optional<StudyOutcome> find(const StudyRun&);
    /// At once, and whole.
    void keep(const StudyRun&, const StudyOutcome&);
    std::uint64_t count();
    /// By settings and seed, in an order that does not depend on when they were kept.
    void for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>&);

    /// What some of its runs set, each once.
    void for_each_setting(const std::function<void(const Overrides&)>&);

    /// What was to be known of the runs when they were added to last.
    void set_measures(const std::vector<std::string>&);
    std::vector<std::string> measures();
    /// What its runs have in common.
    StudySource source();
    /// The netlist's path.
    std::string netlist();
    std::string version();
    const std::filesystem::path& path() const { return path_; }

private:
    /// The rows but the runs, and what checks these.
    struct Head {
        StudySource source;
        std::string version, measures;
        std::int64_t runs = 0, sum = 0;
        std::string texts_checksums = {}; ///< of the source's texts, which may be long and do not change
        void add_up_texts();
        std::int64_t checksum() const; ///< REQUIRES: add_up_texts() was called for these texts
    };

    void open(const StudySource&, bool of_any_version);
    void make(const StudySource&);
    /// Whether something is in it; throws where that is not ours.
    bool is_ours();
    void read_head();
    void write_head();
    void read_runs();
    void check();
    void require_same(const StudySource&);
    void require_version(bool of_any_version);
    [[noreturn]] void refuse_damaged(const std::string& where) const;
    template <class Work>
    auto guarded(Work work);
    template <class Read>
    auto parsed(Read read);

    std::filesystem::path path_;
    std::optional<store::FileLock> lock_; ///< none: to read
    std::optional<store::Database> database_;
    std::optional<store::Statement> has_, find_, insert_, update_;
    Head head_;
};

} // namespace placedpar
