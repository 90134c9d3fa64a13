#include "monitor/memory/history_table.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar::monitor {

std::string HistoryText::of(const std::string& name, const char* statement) {
    return fmt::format(fmt::runtime(statement), name);
}

std::string HistoryText::places(int columns) {
    std::string text = "?1";
    for (int i = 2; i <= columns; ++i)
        text += fmt::format(", ?{}", i);
    return text;
}

void HistoryText::throw_damaged(std::uint64_t number, const std::string& machine, const std::string& name) {
    throw std::runtime_error(
        fmt::format("row {} of the machine \"{}\" in the table of {} is damaged", number, machine, name));
}

// SQLite does not store a negative zero. The addition of 0.0 makes a negative zero positive.
std::string HistoryText::exact(const std::optional<double>& number) {
    return number ? fmt::format("{}", *number + 0.0) : "none";
}

} // namespace placedpar::monitor
