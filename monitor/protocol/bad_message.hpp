#pragma once

#include "identification/on_line/refused_sample.hpp"
#include "text/user_error.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace placedpar::monitor {

/// A line that is refused, in the words of the protocol; what() says what is wrong.
class BadMessage : public UserError {
public:
    BadMessage(std::string field, const std::string& wrong, std::string right, std::optional<std::size_t> column = {})
        : UserError(wrong), field_(std::move(field)), right_(std::move(right)), column_(column) {}
    /// A sample that could be read, but not taken.
    explicit BadMessage(const identification::RefusedSample& refused);

    /// "links.BO.inlet_psi"; empty when the line is no JSON object.
    const std::string& field() const { return field_; }
    /// What would be right.
    const std::string& right() const { return right_; }
    /// From 1; of lines that are no JSON.
    std::optional<std::size_t> column() const { return column_; }

private:
    std::string field_, right_;
    std::optional<std::size_t> column_;
};

} // namespace placedpar::monitor
