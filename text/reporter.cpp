#include "text/reporter.hpp"

#include <algorithm>

namespace placedpar {

void Reporter::error(const Location& location, std::string message, std::string hint, std::vector<SecondPlace> others) {
    if (has_error_at(location)) {
        if (++repeated_ >= most_repeated)
            throw GiveUp{};
        return;
    }
    diagnostics_.push_back({Severity::error, std::move(message), location, std::move(hint), std::move(others)});
    if (++errors_ >= most_errors)
        throw GiveUp{};
}

void Reporter::give_up(const Location& location, std::string message, std::vector<SecondPlace> others) {
    error(location, std::move(message), "", std::move(others));
    throw GiveUp{};
}

void Reporter::warning(const Location& location, std::string message, std::string hint) {
    if (diagnostics_.size() < 10 * most_errors)
        diagnostics_.push_back({Severity::warning, std::move(message), location, std::move(hint), {}});
}

bool Reporter::has_error_at(const Location& place) const {
    return place.file && std::ranges::any_of(diagnostics_, [&](const Diagnostic& known) {
               return known.severity == Severity::error && known.location == place;
           });
}

} // namespace placedpar
