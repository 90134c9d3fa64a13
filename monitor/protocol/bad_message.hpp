#pragma once

#include "identification/on_line/refused_sample.hpp"
#include "text/user_error.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace placedpar::monitor {

/// Reports a line of a client that the service refuses, with the wrong field and what would be right. what() states the
/// error.
class BadMessage : public UserError {
public:
    BadMessage(std::string field, const std::string& wrong, std::string right, std::optional<std::size_t> column = {})
        : UserError(wrong), field_(std::move(field)), right_(std::move(right)), column_(column) {}
    /// Reports a well-formed sample that the diagnosis refuses.
    explicit BadMessage(const identification::RefusedSample& refused);

    /// Returns the path of the field, such as "links.BO.inlet_psi"; empty if the line is not a JSON object.
    const std::string& field() const { return field_; }
    /// Returns what would be accepted.
    const std::string& right() const { return right_; }
    /// Returns the column, counted from 1, at which the line is not valid JSON.
    std::optional<std::size_t> column() const { return column_; }

private:
    std::string field_, right_;
    std::optional<std::size_t> column_;
};

} // namespace placedpar::monitor
