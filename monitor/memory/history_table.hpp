#pragma once

#include "monitor/memory/described.hpp"
#include "store/database.hpp"
#include "text/checksum.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// The parts of HistoryTable that do not depend on the type of its rows.
class HistoryText {
protected:
    /// Returns the statement with the table's name in place of {}.
    static std::string of(const std::string& name, const char* statement);
    /// Returns `columns` placeholders: "?1, ?2" for 2.
    static std::string places(int columns);
    [[noreturn]] static void throw_damaged(std::uint64_t number, const std::string& machine, const std::string& name);

    static const std::string& exact(const std::string& text) { return text; }
    static std::string exact(const std::optional<double>& number);
};

/// A table of structs in an SQLite database, for the history of each machine (excavator). Boost.Describe gives the
/// members of the struct; the first member is the machine. The columns are the machine, the row's number among the
/// machine's rows, the other members, and a checksum of all these columns. The table keeps the newest `most` rows of
/// each machine.
template <typename Row>
class HistoryTable : HistoryText {
public:
    HistoryTable(store::Database& database, const std::string& name, std::uint64_t most)
        : name_(name), most_(most),
          next_(database, of("SELECT coalesce(max(number), 0) + 1 FROM {} WHERE machine = ?1")),
          insert_(database, of("INSERT INTO {} VALUES(") + places(columns) + ")"),
          erase_(database, of("DELETE FROM {} WHERE machine = ?1 AND number = ?2")),
          trim_(database, of("DELETE FROM {} WHERE machine = ?1 AND number <= ?2")),
          forget_(database, of("DELETE FROM {} WHERE machine = ?1")), all_(database, of("SELECT * FROM {}")),
          newest_(database, of("SELECT * FROM {} WHERE machine = ?1 ORDER BY number DESC LIMIT ?2")) {}

    static std::uint64_t number(const store::Statement& row) { return static_cast<std::uint64_t>(row.integer(1)); }
    static Row row(const store::Statement& found) {
        Row row;
        int column = 0;
        for_each_member(row, [&](const std::string&, auto& member) {
            read(found, column, member);
            column += column == 0 ? 2 : 1; // skips the row's number
        });
        return row;
    }
    static std::vector<Row> rows(store::Statement& found) {
        std::vector<Row> rows;
        while (found.step())
            rows.push_back(row(found));
        return rows;
    }

    /// Reads every row and returns the sum of their checksums. Throws std::runtime_error, naming the first row with a
    /// wrong checksum.
    std::uint64_t check() {
        std::uint64_t sum = 0;
        for (all_.bind(); all_.step();) {
            const std::int64_t checksum = checksum_of_row(number(all_), row(all_));
            if (checksum != all_.integer(columns - 1))
                throw_damaged(number(all_), all_.text(0), name_);
            sum += static_cast<std::uint64_t>(checksum);
        }
        return sum;
    }
    void keep(const Row& row) {
        auto number = static_cast<std::uint64_t>(next_.only_integer(row.machine));
        insert(number, row);
        if (number > most_)
            trim_.run(row.machine, number - most_);
    }
    void replace(std::uint64_t number, const Row& row) {
        erase_.run(row.machine, number);
        insert(number, row);
    }
    void forget(const std::string& machine) { forget_.run(machine); }
    std::vector<Row> newest(const std::string& machine, std::uint64_t most) {
        return rows(newest_.bind(machine, most));
    }

private:
    static constexpr int columns = static_cast<int>(boost::mp11::mp_size<MembersOf<Row>>::value) + 2;

    std::string of(const char* statement) const { return HistoryText::of(name_, statement); }
    void insert(std::uint64_t number, const Row& row) {
        [&]<typename Machine, typename... Others>(boost::mp11::mp_list<Machine, Others...>) {
            insert_.run(row.machine, number, row.*Others::pointer..., checksum_of_row(number, row));
        }(boost::mp11::mp_rename<MembersOf<Row>, boost::mp11::mp_list>());
    }
    static std::int64_t checksum_of_row(std::uint64_t number, const Row& row) {
        return [&]<typename... Each>(boost::mp11::mp_list<Each...>) {
            return checksum_of(std::to_string(number), exact(row.*Each::pointer)...);
        }(boost::mp11::mp_rename<MembersOf<Row>, boost::mp11::mp_list>());
    }
    static void read(const store::Statement& row, int column, std::string& text) { text = row.text(column); }
    static void read(const store::Statement& row, int column, double& number) { number = row.number(column); }
    static void read(const store::Statement& row, int column, std::optional<double>& number) {
        number = row.optional_number(column);
    }

    std::string name_;
    std::uint64_t most_;
    store::Statement next_, insert_, erase_, trim_, forget_, all_, newest_;
};

} // namespace placedpar::monitor
