#pragma once

#include "text/user_error.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace placedpar::store {

/// Reports an error with SQLite's message, followed by the operating system's message if there is one. `damage()`
/// returns whether the file is damaged, or is not a database.
class DatabaseError : public UserError {
public:
    DatabaseError(const std::string& what, bool damage) : UserError(what), damage_(damage) {}
    bool damage() const { return damage_; }

private:
    bool damage_;
};

/// An open SQLite database. The functions of this class and of Statement throw DatabaseError. The class is not
/// thread-safe.
class Database {
public:
    /// Opens the database. If `make` is true and the file does not exist, creates the file.
    explicit Database(const std::filesystem::path& path, bool make = true);

    /// Executes SQL statements without parameters, and discards their results.
    void run(const std::string& sql);
    /// Rolls back the current transaction, if there is one.
    void roll_back() noexcept;
    /// These two functions execute a query and return the first column of its first row; 0 or "" if there is no row.
    std::int64_t integer(const std::string& sql);
    std::string text(const std::string& sql);

    sqlite3* handle() const { return handle_.get(); }

private:
    struct Close {
        void operator()(sqlite3* handle) const;
    };
    std::unique_ptr<sqlite3, Close> handle_;
};

/// An SQL statement, which may have parameters ?1, ?2... REQUIRES: the database outlives the statement.
class Statement {
public:
    Statement(Database& database, const std::string& sql);

    /// Gives values to all parameters, in their order. The next step() then executes the statement from its beginning.
    template <typename... Values>
    Statement& bind(const Values&... values) {
        reset();
        int index = 0;
        (bind_one(++index, values), ...);
        return *this;
    }
    /// Moves to the next row; returns false if there are no more rows.
    bool step();
    /// Binds the parameters and executes the statement.
    template <typename... Values>
    void run(const Values&... values) {
        bind(values...);
        while (step()) {
        }
        reset();
    }

    /// Binds the parameters and returns the first column of the first row; 0 if there is no row.
    template <typename... Values>
    std::int64_t only_integer(const Values&... values) {
        std::int64_t found = bind(values...).step() ? integer(0) : 0;
        reset();
        return found;
    }
    /// Stops reading rows. Call reset() if not all rows have been read: an unfinished statement keeps SQLite from
    /// reusing the beginning of its write-ahead log.
    void reset();

    /// These functions return a column of the present row, counted from 0. The row is valid until the next step().
    std::int64_t integer(int column) const;
    double number(int column) const;
    std::optional<double> optional_number(int column) const;
    std::string text(int column) const;

private:
    void bind_one(int index, std::int64_t value);
    void bind_one(int index, std::uint64_t value) { bind_one(index, static_cast<std::int64_t>(value)); }
    void bind_one(int index, double value);
    void bind_one(int index, const std::optional<double>& value);
    void bind_one(int index, std::string_view value);
    void bind_one(int index, const std::string& value) { bind_one(index, std::string_view(value)); }

    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    sqlite3* database_;
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

} // namespace placedpar::store
