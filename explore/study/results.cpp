#include "explore/study/results.hpp"

#include "netlist/print/print.hpp"
#include "report/manifest.hpp"
#include "text/checksum.hpp"
#include "text/counted.hpp"
#include "text/load_source.hpp"
#include "text/number.hpp"
#include "text/program_name.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <utility>

namespace placedpar {

namespace {

constexpr std::int64_t results_application = 0x50507374; // "PPst"
constexpr std::int64_t results_format = 2;               // format 1 had no checksums

constexpr const char* results_schema =
    "CREATE TABLE study(id INTEGER PRIMARY KEY CHECK(id = 1), netlist TEXT NOT NULL, options TEXT NOT NULL, "
    "version TEXT NOT NULL, measures TEXT NOT NULL, runs INTEGER NOT NULL, sum INTEGER NOT NULL, "
    "checksum INTEGER NOT NULL) STRICT;"
    "CREATE TABLE texts(place INTEGER PRIMARY KEY, path TEXT NOT NULL, text TEXT NOT NULL) STRICT;"
    "CREATE TABLE runs(settings TEXT NOT NULL, seed INTEGER NOT NULL, ended TEXT NOT NULL, time_ps INTEGER NOT NULL, "
    "fingerprint TEXT NOT NULL, netlist_hash TEXT NOT NULL, version TEXT NOT NULL, refused TEXT NOT NULL, "
    "figures TEXT NOT NULL, checksum INTEGER NOT NULL, PRIMARY KEY(settings, seed)) STRICT, WITHOUT ROWID;";

const std::string run_columns =
    "SELECT settings, seed, ended, time_ps, fingerprint, netlist_hash, version, refused, figures, checksum FROM runs";
constexpr int columns_checked = 9, checksum_column = 9;

std::string settings_json(const Overrides& set) { return boost::json::serialize(boost::json::value_from(set)); }

Overrides settings_from(const std::string& text) { return boost::json::value_to<Overrides>(read_kept_json(text)); }

std::string options_of(const Study& study) {
    boost::json::object programs;
    for (const auto& [program, kind] : study.read.programs)
        programs[program] = kind;
    boost::json::object json{{"faults", boost::json::array(study.read.faults.begin(), study.read.faults.end())},
                             {"programs", programs}};
    if (!study.prices.empty())
        json["price"] = boost::json::value_from(study.prices);
    if (study.until != Time::max())
        json["until_ps"] = study.until.count();
    return boost::json::serialize(json);
}

std::string text_of_file(const std::string& path) {
    LoadedSource loaded = load_input(path);
    if (has_errors(loaded.problems))
        throw RefusedInput(render(loaded.problems));
    return loaded.file->text();
}

/// Throws UserError if the path is a folder, or anything else but a file. SQLite would say only that it cannot open the
/// file.
void require_no_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    if (is_standard_stream(path) ||
        (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)))
        throw UserError(fmt::format("{}: this is not a file; name a file for the results, which need not exist yet",
                                    path.string()));
}

void make_file(const std::filesystem::path& path) {
    if (!std::ofstream(path, std::ios::app))
        throw UserError(fmt::format("{}: the file cannot be created: {}", path.string(), std::strerror(errno)));
}

std::uint64_t fingerprint_from(const std::string& text) { return parse_number<std::uint64_t>(text, 16).value(); }

/// Returns the definitions of all objects of the database as text. A file of results is refused if its text differs
/// from schema_of_ours(). Another program may have added objects, such as triggers, which would change the effect of
/// the statements of this file.
std::string schema_of(store::Database& database) {
    return database.text("SELECT group_concat(type || ' ' || name || ' ' || tbl_name || ' ' || ifnull(sql, ''), '; ') "
                         "FROM (SELECT * FROM sqlite_schema ORDER BY type, name)");
}

std::string schema_of_ours() {
    store::Database database(":memory:");
    database.run(results_schema);
    return schema_of(database);
}

template <typename... Columns>
std::int64_t checksum_of_run(const Columns&... columns) {
    return checksum_of("run", fmt::format("{}", columns)...);
}

/// Computes the checksum of the run in this row from the row's other columns.
std::int64_t checksum_in(const store::Statement& row) {
    auto of = [&]<int... column>(std::integer_sequence<int, column...>) {
        return checksum_of_run(row.text(column)...);
    };
    return of(std::make_integer_sequence<int, columns_checked>());
}

StudyRun run_in(const store::Statement& row) {
    return {settings_from(row.text(0)), static_cast<std::uint64_t>(row.integer(1))};
}

StudyOutcome outcome_in(const store::Statement& row) {
    return {row.text(2), Time{row.integer(3)},     fingerprint_from(row.text(4)), fingerprint_from(row.text(5)),
            row.text(7), figures_from(row.text(8))};
}

} // namespace

bool StudySource::operator==(const StudySource& other) const {
    auto same_text = [](const auto& a, const auto& b) { return a.second == b.second; };
    return options == other.options &&
           std::equal(texts.begin(), texts.end(), other.texts.begin(), other.texts.end(), same_text);
}

StudySource source_of(const Study& study, const Network& network) {
    const std::string shown = shown_input(study.netlist);
    StudySource source{shown, {{shown, text_of_file(study.netlist)}}, options_of(study)};
    for (const std::string& path : network.included_paths)
        source.texts.emplace_back(path, text_of_file(path));
    for (const Node& node : network.nodes) // a hash, because the bytes are not text
        if (!node.boot_file.empty())
            source.texts.emplace_back(node.boot_file, hex(boot_hash(node)));
    return source;
}

void StudyResults::Head::add_up_texts() {
    texts_checksums.clear();
    for (const auto& [path, text] : source.texts)
        texts_checksums += hex(static_cast<std::uint64_t>(checksum_of(path, text)));
}

std::int64_t StudyResults::Head::checksum() const {
    return checksum_of(source.netlist, source.options, version, measures, std::to_string(runs), std::to_string(sum),
                       texts_checksums);
}

/// Calls `work`; reports an error of SQLite with the file's name.
template <class Work>
auto StudyResults::guarded(Work work) {
    try {
        return work();
    } catch (const store::DatabaseError& error) {
        if (error.damage())
            refuse_damaged(error.what());
        throw UserError(fmt::format("{}: {}", path_.string(), error.what()));
    }
}

/// Calls `read`; reports a row that cannot be parsed. Such a row may have a correct checksum if another program wrote
/// it.
template <class Read>
auto StudyResults::parsed(Read read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        refuse_damaged(fmt::format("PlacedPar did not write this row: {}", error.what()));
    }
}

void StudyResults::refuse_damaged(const std::string& where) const {
    throw UserError(fmt::format("{}: the file is damaged ({}): restore an earlier copy, or move the file away "
                                "and start again",
                                path_.string(), where));
}

StudyResults::StudyResults(const std::filesystem::path& path, const StudySource& source, bool of_any_version)
    : path_(path) {
    require_no_folder(path);
    make_file(path);
    lock_.emplace(path, path.string(), program_name() + " sweep or optimise");
    open(source, of_any_version);
}

StudyResults::StudyResults(const StudySource& source) : path_(":memory:") { open(source, false); }

void StudyResults::open(const StudySource& source, bool of_any_version) {
    guarded([&] {
        database_.emplace(path_);
        if (!is_ours())
            make(source);
        if (std::string fault = database_->text("PRAGMA integrity_check(1)"); fault != "ok")
            refuse_damaged(fault); // in a damaged file SQLite could overwrite valid data
        check();
        require_same(source);
        require_version(of_any_version);
        database_->run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
        has_.emplace(*database_, "SELECT 1 FROM runs WHERE settings = ?1 AND seed = ?2");
        find_.emplace(*database_, run_columns + " WHERE settings = ?1 AND seed = ?2");
        insert_.emplace(*database_, "INSERT INTO runs VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10)");
        update_.emplace(*database_, "UPDATE study SET version = ?1, measures = ?2, runs = ?3, sum = ?4, checksum = ?5");
        write_head();
    });
}

StudyResults::StudyResults(const std::filesystem::path& path) : path_(path) {
    if (!std::filesystem::exists(path))
        throw UserError(fmt::format("{}: this file does not exist; {} sweep makes it", path.string(), program_name()));
    require_no_folder(path);
    guarded([&] {
        database_.emplace(path);
        database_->run("BEGIN");
        if (!is_ours())
            throw UserError(
                fmt::format("{}: the file is empty; {} sweep adds runs to it", path_.string(), program_name()));
        check();
    });
}

/// Removes SQLite's companion files, unless another process is reading the file.
StudyResults::~StudyResults() {
    try {
        has_.reset();
        find_.reset();
        insert_.reset();
        update_.reset();
        if (lock_ && database_)
            database_->run("PRAGMA journal_mode = DELETE");
    } catch (const store::DatabaseError&) { // the companion files then remain, but the file itself is complete
    }
}

bool StudyResults::is_ours() {
    try {
        std::int64_t application = database_->integer("PRAGMA application_id");
        if (application == 0 && database_->integer("SELECT count(*) FROM sqlite_schema") == 0)
            return false;
        if (application != results_application)
            throw UserError(
                fmt::format("{}: the file is a database of another program; name another file", path_.string()));
    } catch (const store::DatabaseError& error) {
        if (!error.damage())
            throw;
        throw UserError(fmt::format("{}: the file is not a results file ({}): name another file, or move this "
                                    "file away",
                                    path_.string(), error.what()));
    }
    if (std::int64_t format = database_->integer("PRAGMA user_version"); format != results_format)
        throw UserError(
            fmt::format("{}: the file has format {}, from {} version of PlacedPar; this version "
                        "reads format {}",
                        path_.string(), format, format > results_format ? "a later" : "an earlier",
                        format > results_format
                            ? fmt::format("{}", results_format)
                            : fmt::format("{}: use the other version to report its runs, or sweep again with another "
                                          "--results",
                                          results_format)));
    if (schema_of(*database_) != schema_of_ours())
        refuse_damaged("its tables differ from those that PlacedPar makes");
    return true;
}

void StudyResults::make(const StudySource& source) {
    database_->run("BEGIN IMMEDIATE");
    database_->run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; {}", results_application,
                               results_format, results_schema));
    head_ = {source, version_text(), "[]"};
    head_.add_up_texts();
    store::Statement(*database_, "INSERT INTO study VALUES(1, ?1, ?2, ?3, ?4, 0, 0, ?5)")
        .run(source.netlist, source.options, head_.version, head_.measures, head_.checksum());
    store::Statement text(*database_, "INSERT INTO texts VALUES(?1, ?2, ?3)");
    for (std::size_t i = 0; i < source.texts.size(); ++i)
        text.run(std::uint64_t{i}, source.texts[i].first, source.texts[i].second);
    database_->run("COMMIT");
}

void StudyResults::read_head() {
    store::Statement row(*database_, "SELECT netlist, options, version, measures, runs, sum, checksum FROM study");
    if (!row.step())
        refuse_damaged("table study has no row");
    head_ = {{row.text(0), {}, row.text(1)}, row.text(2), row.text(3), row.integer(4), row.integer(5)};
    const std::int64_t checksum = row.integer(6);
    store::Statement texts(*database_, "SELECT path, text FROM texts ORDER BY place");
    while (texts.step())
        head_.source.texts.emplace_back(texts.text(0), texts.text(1));
    head_.add_up_texts();
    if (checksum != head_.checksum())
        refuse_damaged("the row of table study, or a row of table texts");
}

/// Reads the runs in their order. A run whose key is not above the previous key is refused, so no run occurs twice.
/// This check also ends the reading of a damaged file whose pages refer to one another in a circle.
void StudyResults::read_runs() {
    std::int64_t count = 0, sum = 0;
    std::pair<std::string, std::int64_t> last;
    store::Statement row(*database_, run_columns + " ORDER BY settings, seed");
    for (; row.step(); ++count) {
        const std::int64_t checksum = row.integer(checksum_column);
        std::pair key(row.text(0), row.integer(1));
        if (checksum != checksum_in(row) || (count > 0 && key <= last))
            refuse_damaged(fmt::format("row {} of table runs", count + 1));
        last = std::move(key);
        sum ^= checksum;
    }
    if (count != head_.runs || sum != head_.sum)
        refuse_damaged(count != head_.runs ? fmt::format("table runs has {}, but should have {}",
                                                         counted(static_cast<std::size_t>(count), "row"), head_.runs)
                                           : "a row of table runs comes from another file");
}

void StudyResults::check() {
    read_head();
    read_runs();
}

void StudyResults::write_head() {
    update_->run(head_.version, head_.measures, head_.runs, head_.sum, head_.checksum());
}

StudySource StudyResults::source() { return head_.source; }

namespace {

/// Says how the source of the file's runs differs from the wanted source. REQUIRES: the sources differ.
std::string print_difference(const StudySource& kept, const StudySource& wanted) {
    if (kept.options != wanted.options)
        return fmt::format("the file's runs were made with other options ({}, not {})", kept.options, wanted.options);
    const bool same_netlist =
        kept.texts.size() == wanted.texts.size() && kept.texts[0].second == wanted.texts[0].second;
    for (std::size_t i = 1; same_netlist && i < kept.texts.size(); ++i)
        if (kept.texts[i].second != wanted.texts[i].second)
            return fmt::format("the file's runs were made with other contents of {}", wanted.texts[i].first);
    return fmt::format("the file's runs were made from {}, whose text differs from this netlist's", kept.netlist);
}

} // namespace

void StudyResults::require_same(const StudySource& wanted) {
    if (head_.source == wanted)
        return;
    throw UserError(fmt::format("{}: {}; name another file{}, or move this file away", path_.string(),
                                print_difference(head_.source, wanted), wanted.named_by));
}

void StudyResults::require_version(bool of_any_version) {
    std::string kept = version();
    if (kept == version_text())
        return;
    if (!of_any_version)
        throw UserError(fmt::format("{}: the file's runs were made by version {}, but this is version {}; name "
                                    "another file with --results, or use --any-version to keep runs of both",
                                    path_.string(), kept, version_text()));
    head_.version = version_text();
}

bool StudyResults::has(const StudyRun& run) {
    return guarded([&] { return has_->only_integer(settings_json(run.set), run.seed) != 0; });
}

std::optional<StudyOutcome> StudyResults::find(const StudyRun& run) {
    return guarded([&] {
        std::optional<StudyOutcome> found;
        if (find_->bind(settings_json(run.set), run.seed).step())
            found = parsed([&] { return outcome_in(*find_); });
        find_->reset();
        return found;
    });
}

void StudyResults::keep(const StudyRun& run, const StudyOutcome& outcome) {
    if (has(run))
        return;
    const auto [runs_before, sum_before] = std::pair(head_.runs, head_.sum);
    const std::string set = settings_json(run.set), figures = figures_text(outcome.figures);
    const auto seed = static_cast<std::int64_t>(run.seed), time = std::int64_t{outcome.time.count()};
    const std::int64_t checksum = checksum_of_run(set, seed, outcome.ended, time, hex(outcome.fingerprint),
                                                  hex(outcome.netlist_hash), version_text(), outcome.refused, figures);
    try {
        database_->run("BEGIN IMMEDIATE");
        insert_->run(set, seed, outcome.ended, time, hex(outcome.fingerprint), hex(outcome.netlist_hash),
                     version_text(), outcome.refused, figures, checksum);
        ++head_.runs;
        head_.sum ^= checksum;
        write_head();
        database_->run("COMMIT");
    } catch (const store::DatabaseError& error) {
        database_->roll_back();
        head_.runs = runs_before;
        head_.sum = sum_before;
        throw UserError(fmt::format("{}: {}; its finished runs are kept: type the same command again to continue",
                                    path_.string(), error.what()));
    }
}

std::uint64_t StudyResults::count() {
    return guarded([&] { return static_cast<std::uint64_t>(database_->integer("SELECT count(*) FROM runs")); });
}

void StudyResults::for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>& tell) {
    guarded([&] {
        store::Statement rows(*database_, run_columns + " ORDER BY settings, seed");
        while (rows.step())
            tell(parsed([&] { return run_in(rows); }), parsed([&] { return outcome_in(rows); }));
    });
}

void StudyResults::for_each_setting(const std::function<void(const Overrides&)>& tell) {
    guarded([&] {
        store::Statement rows(*database_, "SELECT DISTINCT settings FROM runs ORDER BY settings");
        while (rows.step())
            tell(parsed([&] { return settings_from(rows.text(0)); }));
    });
}

void StudyResults::set_measures(const std::vector<std::string>& measures) {
    guarded([&] {
        head_.measures = boost::json::serialize(boost::json::array(measures.begin(), measures.end()));
        write_head();
    });
}

std::vector<std::string> StudyResults::measures() {
    return parsed([&] { return boost::json::value_to<std::vector<std::string>>(read_kept_json(head_.measures)); });
}

std::string StudyResults::netlist() { return head_.source.netlist; }

std::string StudyResults::version() { return head_.version; }

} // namespace placedpar
