#pragma once

#include "text/user_error.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// Reports a machine or a motion that cannot be simulated or measured. what() names the invalid value and its valid
/// range.
class UnfitScenario : public UserError {
public:
    using UserError::UserError;
};

/// Checks the values of a machine or a scenario. All functions throw UnfitScenario with a text such as "measured
/// machine: the boom's mass is -1, expected above 0".
struct Requirement {
    std::string_view of; ///< what is checked, such as "measured machine"

    [[noreturn]] void refuse(std::string_view what, double value, std::string_view expected) const;
    void positive(std::string_view what, double value) const;
    void not_negative(std::string_view what, double value) const;
    void finite(std::string_view what, double value) const;
    /// Requires a value above 0 and below 1.
    void share(std::string_view what, double value) const;
    /// Requires a motion of so few integration steps that the whole motion can be kept in memory.
    void kept_whole(double duration_s, double integration_step_s) const;
};

} // namespace placedpar::hydraulics
