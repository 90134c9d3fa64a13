#pragma once

#include "text/diagnostic.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace placedpar {

inline constexpr std::size_t most_errors = 20;
/// Errors at places that are known already: a replicated statement goes wrong each time.
inline constexpr std::size_t most_repeated = 50;

/// Thrown, and caught within the room, when going on makes no sense: too many errors, a bound exceeded.
struct GiveUp {};

/// Collects what is wrong while a netlist is read.
class Reporter {
public:
    /// Keeps one error a place: the second replication of a statement says nothing new. Throws GiveUp after
    /// the last error that is kept.
    void error(const Location& location, std::string message, std::string hint = "",
               std::vector<SecondPlace> others = {}) {
        if (is_known(location)) {
            if (++repeated_ >= most_repeated)
                throw GiveUp{};
            return;
        }
        diagnostics_.push_back({Severity::error, std::move(message), location, std::move(hint), std::move(others)});
        if (++errors_ >= most_errors)
            throw GiveUp{};
    }

    void warning(const Location& location, std::string message, std::string hint = "") {
        if (diagnostics_.size() < 10 * most_errors)
            diagnostics_.push_back({Severity::warning, std::move(message), location, std::move(hint), {}});
    }

    bool failed() const { return errors_ > 0; }
    std::vector<Diagnostic> take() { return std::move(diagnostics_); }

private:
    bool is_known(const Location& place) const {
        return place.file && std::any_of(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& known) {
                   return known.severity == Severity::error && known.location.file == place.file &&
                          known.location.line == place.line && known.location.column == place.column;
               });
    }

    std::vector<Diagnostic> diagnostics_;
    std::size_t errors_ = 0, repeated_ = 0;
};

} // namespace placedpar
