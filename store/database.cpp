#include "store/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstring>

namespace placedpar::store {

namespace {

/// The time to wait for a lock that another program holds, such as a database browser.
constexpr int busy_ms = 5000;

[[noreturn]] void fail(sqlite3* database) {
    int code = sqlite3_errcode(database), reason = sqlite3_system_errno(database);
    bool disk = code == SQLITE_IOERR || code == SQLITE_FULL || code == SQLITE_CANTOPEN;
    throw DatabaseError(fmt::format("{}{}", sqlite3_errmsg(database),
                                    disk && reason != 0 ? fmt::format(" ({})", std::strerror(reason)) : std::string()),
                        code == SQLITE_CORRUPT || code == SQLITE_NOTADB);
}

void require(sqlite3* database, int code) {
    if (code != SQLITE_OK)
        fail(database);
}

} // namespace

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Database::Database(const std::filesystem::path& path, bool make) {
    sqlite3* handle = nullptr;
    int code = sqlite3_open_v2(path.c_str(), &handle, SQLITE_OPEN_READWRITE | (make ? SQLITE_OPEN_CREATE : 0), nullptr);
    handle_.reset(handle);
    require(handle, code);
    require(handle, sqlite3_extended_result_codes(handle, 0));
    require(handle, sqlite3_busy_timeout(handle, busy_ms));
}

void Database::run(const std::string& sql) {
    require(handle(), sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr));
}

void Database::roll_back() noexcept { sqlite3_exec(handle(), "ROLLBACK", nullptr, nullptr, nullptr); }

std::int64_t Database::integer(const std::string& sql) {
    Statement statement(*this, sql);
    return statement.step() ? statement.integer(0) : 0;
}

std::string Database::text(const std::string& sql) {
    Statement statement(*this, sql);
    return statement.step() ? statement.text(0) : "";
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(Database& database, const std::string& sql) : database_(database.handle()) {
    sqlite3_stmt* statement = nullptr;
    int code = sqlite3_prepare_v2(database_, sql.c_str(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    require(database_, code);
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

bool Statement::step() {
    int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) {
        reset();
        fail(database_);
    }
    return code == SQLITE_ROW;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::number(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::optional<double> Statement::optional_number(int column) const {
    if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL)
        return std::nullopt;
    return number(column);
}

std::string Statement::text(int column) const {
    const auto* text = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return text ? std::string(text, size) : std::string();
}

void Statement::bind_one(int index, std::int64_t value) {
    require(database_, sqlite3_bind_int64(statement_.get(), index, value));
}

void Statement::bind_one(int index, double value) {
    require(database_, sqlite3_bind_double(statement_.get(), index, value));
}

void Statement::bind_one(int index, const std::optional<double>& value) {
    if (value)
        bind_one(index, *value);
    else
        require(database_, sqlite3_bind_null(statement_.get(), index));
}

void Statement::bind_one(int index, std::string_view value) {
    require(database_,
            sqlite3_bind_text(statement_.get(), index, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

} // namespace placedpar::store
