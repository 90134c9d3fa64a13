#pragma once

#include "explore/study/measure.hpp"
#include "explore/study/study.hpp"
#include "netlist/run_outcome.hpp"
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

struct StudyOutcome {
    std::string ended; ///< name_of(RunOutcome), or "refused"
    Time time{};
    std::uint64_t fingerprint = 0;
    std::uint64_t netlist_hash = 0;
    std::string refused = ""; ///< printed reason why the netlist is refused; "" if it is accepted
    StudyFigures figures = {};

    /// Returns whether the figures mean something. In all other cases, such as a deadlock, the work was not done.
    bool has_figures() const {
        return ended == name_of(RunOutcome::completed) || ended == name_of(RunOutcome::time_limit);
    }
};

/// What determines all runs of a file of results, apart from their settings and seeds. A file with another source is
/// refused, so that runs of different netlists never mix. If the study runs a function in place of a netlist, there are
/// no texts.
struct StudySource {
    std::string netlist;                                    ///< path as typed by the user; ignored in comparisons
    std::vector<std::pair<std::string, std::string>> texts; ///< path and text of the netlist and its included files
    std::string options; ///< JSON of everything else that determines a run, such as faults; for a function, a text that
                         ///< identifies the function
    /// Words of the error message that say how the user can name another file of results.
    std::string named_by = " with --results";

    /// Compares everything except the paths of the files and `named_by`.
    bool operator==(const StudySource& other) const;
};
/// Reads the netlist's files. REQUIRES: `network` was read from these files. Throws UserError.
StudySource source_of(const Study&, const Network& network);

/// The runs of one netlist in a SQLite file. Each run is a row, with everything needed to repeat the run. Once keep()
/// has returned, the run stays in the file even if the program crashes. Each row has a checksum, and the file holds the
/// number of rows and the sum of the checksums, so that a damaged file is refused. Functions throw UserError with the
/// file's name.
class StudyResults {
public:
    /// Opens a file to add runs, or creates it. Refuses a file of another netlist, of other options or of another
    /// format. Unless `of_any_version`, refuses a file of another version of PlacedPar. Also refuses a file to which
    /// another program is adding runs.
    StudyResults(const std::filesystem::path&, const StudySource&, bool of_any_version = false);
    /// Opens a file to read it, also while another program adds runs. This object does not see runs that are added
    /// later.
    explicit StudyResults(const std::filesystem::path&);
    /// Keeps the runs only in memory.
    explicit StudyResults(const StudySource&);
    ~StudyResults();

    bool has(const StudyRun&);
    std::optional<StudyOutcome> find(const StudyRun&);
    /// Returns when the run is safely in the file.
    void keep(const StudyRun&, const StudyOutcome&);
    std::uint64_t count();
    /// Calls the function for each run, ordered by settings and seed.
    void for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>&);

    /// Calls the function once for each combination of settings that has runs.
    void for_each_setting(const std::function<void(const Overrides&)>&);

    /// Stores the measures that the latest sweep or search requests.
    void set_measures(const std::vector<std::string>&);
    std::vector<std::string> measures();
    StudySource source();
    std::string netlist();
    std::string version();
    const std::filesystem::path& path() const { return path_; }

private:
    /// The data of the file besides its runs, with the number of runs and the sum of their checksums.
    struct Head {
        StudySource source;
        std::string version, measures;
        std::int64_t runs = 0, sum = 0;
        /// Checksums of the source's texts, stored to save time, because the texts may be long.
        std::string texts_checksums = {};
        void add_up_texts();
        std::int64_t checksum() const; ///< REQUIRES: add_up_texts() was called for these texts
    };

    void open(const StudySource&, bool of_any_version);
    void make(const StudySource&);
    /// Returns whether the file has content; throws if the file is not a file of results.
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
    std::optional<store::FileLock> lock_; ///< empty: the file is only read
    std::optional<store::Database> database_;
    std::optional<store::Statement> has_, find_, insert_, update_;
    Head head_;
};

} // namespace placedpar
