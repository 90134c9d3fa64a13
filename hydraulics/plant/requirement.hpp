#pragma once

#include "text/user_error.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// A machine or a motion of it that cannot be simulated or measured; what() says which value is wrong and what is
/// expected.
class UnfitScenario : public UserError {
public:
    using UserError::UserError;
};

/// What the values of a machine or a scenario must be for it to be simulated. All throw UnfitScenario:
/// "measured machine: the boom's mass is -1, expected above 0".
struct Requirement {
    std::string_view of; ///< "measured machine"

    [[noreturn]] void refuse(std::string_view what, double value, std::string_view expected) const;
    void positive(std::string_view what, double value) const;
    void not_negative(std::string_view what, double value) const;
    void finite(std::string_view what, double value) const;
    /// Above 0 and below 1.
    void share(std::string_view what, double value) const;
};

} // namespace placedpar::hydraulics
