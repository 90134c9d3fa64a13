#include "workbench/study/results.hpp"

#include "text/load_source.hpp"
#include "text/program_name.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"
#include "workbench/manifest.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace placedpar {

namespace {

constexpr std::int64_t results_application = 0x50507374; // "PPst"
constexpr std::int64_t results_format = 1;

constexpr const char* results_schema =
    "CREATE TABLE study(id INTEGER PRIMARY KEY CHECK(id = 1), netlist TEXT NOT NULL, options TEXT NOT NULL, "
    "version TEXT NOT NULL, measures TEXT NOT NULL);"
    "CREATE TABLE texts(place INTEGER PRIMARY KEY, path TEXT NOT NULL, text TEXT NOT NULL);"
    "CREATE TABLE runs(settings TEXT NOT NULL, seed INTEGER NOT NULL, ended TEXT NOT NULL, time_ps INTEGER NOT NULL, "
    "fingerprint TEXT NOT NULL, netlist_hash TEXT NOT NULL, version TEXT NOT NULL, refused TEXT NOT NULL, "
    "figures TEXT NOT NULL, PRIMARY KEY(settings, seed)) WITHOUT ROWID;";

const std::string outcome_columns =
    "SELECT settings, seed, ended, time_ps, fingerprint, netlist_hash, refused, figures FROM runs";

std::string settings_json(const Overrides& set) { return boost::json::serialize(boost::json::value_from(set)); }

Overrides settings_from(const std::string& text) { return boost::json::value_to<Overrides>(boost::json::parse(text)); }

std::string options_of(const Study& study) {
    boost::json::object programs;
    for (const auto& [program, kind] : study.read.programs)
        programs[program] = kind;
    boost::json::object json{{"faults", boost::json::array(study.read.faults.begin(), study.read.faults.end())},
                             {"programs", programs}};
    if (study.until != Time::max())
        json["until_ps"] = study.until.count();
    return boost::json::serialize(json);
}

std::string text_of_file(const std::string& path) {
    LoadedSource loaded = load_source(path);
    if (has_errors(loaded.problems))
        throw RefusedInput(render(loaded.problems));
    return loaded.file->text();
}

/// SQLite would call a folder a file that it is unable to open.
void require_no_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    if (is_standard_stream(path) ||
        (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)))
        throw UserError(fmt::format("{}: results are kept in a file; name one, it need not exist yet", path.string()));
}

void make_file(const std::filesystem::path& path) {
    if (!std::ofstream(path, std::ios::app))
        throw UserError(fmt::format("{}: cannot be made: {}", path.string(), std::strerror(errno)));
}

std::uint64_t fingerprint_from(const std::string& text) { return std::stoull(text, nullptr, 16); }

} // namespace

bool StudySource::operator==(const StudySource& other) const {
    auto same_text = [](const auto& a, const auto& b) { return a.second == b.second; };
    return options == other.options &&
           std::equal(texts.begin(), texts.end(), other.texts.begin(), other.texts.end(), same_text);
}

StudySource source_of(const Study& study, const Network& network) {
    StudySource source{study.netlist, {{study.netlist, text_of_file(study.netlist)}}, options_of(study)};
    for (const std::string& path : network.included_paths)
        source.texts.emplace_back(path, text_of_file(path));
    return source;
}

/// What SQLite says is said of the file.
template <class Work>
auto StudyResults::guarded(Work work) {
    try {
        return work();
    } catch (const store::DatabaseError& error) {
        throw UserError(fmt::format("{}: {}", path_.string(), error.what()));
    }
}

StudyResults::StudyResults(const std::filesystem::path& path, const StudySource& source, bool of_any_version)
    : path_(path) {
    require_no_folder(path);
    make_file(path);
    lock_.emplace(path, path.string(), program_name() + " sweep or optimise");
    guarded([&] {
        database_.emplace(path);
        require_ours();
        if (database_->integer("SELECT count(*) FROM sqlite_schema") == 0)
            make(source);
        require_same(source);
        require_version(of_any_version);
        database_->run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
        has_.emplace(*database_, "SELECT 1 FROM runs WHERE settings = ?1 AND seed = ?2");
        find_.emplace(*database_, outcome_columns + " WHERE settings = ?1 AND seed = ?2");
        insert_.emplace(*database_, "INSERT OR IGNORE INTO runs VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9)");
    });
}

StudyResults::StudyResults(const std::filesystem::path& path) : path_(path) {
    if (!std::filesystem::exists(path))
        throw UserError(fmt::format("{}: there is no such file; {} sweep makes it", path.string(), program_name()));
    require_no_folder(path);
    guarded([&] {
        database_.emplace(path);
        require_ours();
        if (database_->integer("SELECT count(*) FROM sqlite_schema") == 0)
            throw UserError(fmt::format("{}: it is empty; {} sweep adds runs to it", path_.string(), program_name()));
    });
}

/// One file is left of what SQLite has beside it meanwhile, unless somebody is reading it.
StudyResults::~StudyResults() {
    try {
        has_.reset();
        find_.reset();
        insert_.reset();
        if (lock_ && database_)
            database_->run("PRAGMA journal_mode = DELETE");
    } catch (const store::DatabaseError&) { // then it is left as it is, and is whole
    }
}

void StudyResults::require_ours() {
    try {
        std::int64_t application = database_->integer("PRAGMA application_id");
        bool empty = database_->integer("SELECT count(*) FROM sqlite_schema") == 0;
        if (application != results_application && !(empty && application == 0))
            throw UserError(fmt::format("{}: it is a database of another program; name another file", path_.string()));
    } catch (const store::DatabaseError& error) {
        if (!error.damage())
            throw;
        throw UserError(fmt::format("{}: it is no file of results ({})", path_.string(), error.what()));
    }
    if (std::int64_t format = database_->integer("PRAGMA user_version"); format > results_format)
        throw UserError(fmt::format("{}: its format is {}, of a later PlacedPar; this one knows {}", path_.string(),
                                    format, results_format));
}

void StudyResults::make(const StudySource& source) {
    database_->run("BEGIN IMMEDIATE");
    database_->run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; {}", results_application,
                               results_format, results_schema));
    store::Statement(*database_, "INSERT INTO study VALUES(1, ?1, ?2, ?3, '[]')")
        .run(source.netlist, source.options, version_text());
    store::Statement text(*database_, "INSERT INTO texts VALUES(?1, ?2, ?3)");
    for (std::size_t i = 0; i < source.texts.size(); ++i)
        text.run(std::uint64_t{i}, source.texts[i].first, source.texts[i].second);
    database_->run("COMMIT");
}

StudySource StudyResults::source() {
    StudySource source{netlist(), {}, database_->text("SELECT options FROM study")};
    store::Statement rows(*database_, "SELECT path, text FROM texts ORDER BY place");
    while (rows.step())
        source.texts.emplace_back(rows.text(0), rows.text(1));
    return source;
}

void StudyResults::require_same(const StudySource& wanted) {
    StudySource kept = source();
    if (kept == wanted)
        return;
    std::string why =
        kept.options != wanted.options
            ? fmt::format("its runs were made with other options ({}, not {})", kept.options, wanted.options)
            : fmt::format("its runs are of {}, as that was then", kept.netlist);
    throw UserError(
        fmt::format("{}: {}; name another file with --results, or move this one away", path_.string(), why));
}

void StudyResults::require_version(bool of_any_version) {
    std::string kept = version();
    if (kept == version_text())
        return;
    if (!of_any_version)
        throw UserError(fmt::format("{}: its runs were made by version {}, and this is {}; name another file with "
                                    "--results, or say --any-version to keep both in it",
                                    path_.string(), kept, version_text()));
    store::Statement(*database_, "UPDATE study SET version = ?1").run(version_text());
}

bool StudyResults::has(const StudyRun& run) {
    return guarded([&] { return has_->only_integer(settings_json(run.set), run.seed) != 0; });
}

StudyOutcome StudyResults::outcome_in(const store::Statement& row) {
    return {row.text(2), Time{row.integer(3)},     fingerprint_from(row.text(4)), fingerprint_from(row.text(5)),
            row.text(6), figures_from(row.text(7))};
}

std::optional<StudyOutcome> StudyResults::find(const StudyRun& run) {
    return guarded([&] {
        std::optional<StudyOutcome> found;
        if (find_->bind(settings_json(run.set), run.seed).step())
            found = outcome_in(*find_);
        find_->reset();
        return found;
    });
}

void StudyResults::keep(const StudyRun& run, const StudyOutcome& outcome) {
    try {
        insert_->run(settings_json(run.set), run.seed, outcome.ended, std::int64_t{outcome.time.count()},
                     hex(outcome.fingerprint), hex(outcome.netlist_hash), version_text(), outcome.refused,
                     figures_text(outcome.figures));
    } catch (const store::DatabaseError& error) {
        throw UserError(fmt::format("{}: {}; the runs that it has are kept, and the same command goes on from them",
                                    path_.string(), error.what()));
    }
}

std::uint64_t StudyResults::count() {
    return guarded([&] { return static_cast<std::uint64_t>(database_->integer("SELECT count(*) FROM runs")); });
}

void StudyResults::for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>& tell) {
    guarded([&] {
        store::Statement rows(*database_, outcome_columns + " ORDER BY settings, seed");
        while (rows.step())
            tell({settings_from(rows.text(0)), static_cast<std::uint64_t>(rows.integer(1))}, outcome_in(rows));
    });
}

void StudyResults::for_each_setting(const std::function<void(const Overrides&)>& tell) {
    guarded([&] {
        store::Statement rows(*database_, "SELECT DISTINCT settings FROM runs ORDER BY settings");
        while (rows.step())
            tell(settings_from(rows.text(0)));
    });
}

void StudyResults::set_measures(const std::vector<std::string>& measures) {
    guarded([&] {
        store::Statement(*database_, "UPDATE study SET measures = ?1")
            .run(boost::json::serialize(boost::json::array(measures.begin(), measures.end())));
    });
}

std::vector<std::string> StudyResults::measures() {
    const std::string kept = guarded([&] { return database_->text("SELECT measures FROM study"); });
    return boost::json::value_to<std::vector<std::string>>(boost::json::parse(kept));
}

std::string StudyResults::netlist() {
    return guarded([&] { return database_->text("SELECT netlist FROM study"); });
}

std::string StudyResults::version() {
    return guarded([&] { return database_->text("SELECT version FROM study"); });
}

} // namespace placedpar
