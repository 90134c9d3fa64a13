#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

inline constexpr std::size_t most_errors = 20;
/// Errors at places that have one already: what is read in a loop goes wrong each time.
inline constexpr std::size_t most_repeated = 50;

/// Thrown when reading on makes no sense: too many errors, a bound exceeded. The last diagnostic says why. It is no
/// error of its own: the reader that owns the reporter catches it.
struct GiveUp {};

/// Collects what is wrong while a text is read.
class Reporter {
public:
    /// Keeps one error a place: a second one there says nothing new. Throws GiveUp after the last error that is kept.
    void error(const Location& location, std::string message, std::string hint = "",
               std::vector<SecondPlace> others = {});
    /// The last error: there is no sense in reading on.
    [[noreturn]] void give_up(const Location& location, std::string message, std::vector<SecondPlace> others = {});
    void warning(const Location& location, std::string message, std::string hint = "");

    bool failed() const { return errors_ > 0; }
    std::vector<Diagnostic> take() { return std::move(diagnostics_); }

private:
    bool has_error_at(const Location& place) const;

    std::vector<Diagnostic> diagnostics_;
    std::size_t errors_ = 0, repeated_ = 0;
};

} // namespace placedpar
