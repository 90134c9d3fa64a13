#pragma once

#include "netlist/read.hpp"

#include <memory>
#include <string>

namespace placedpar {

/// Which of a study's products are run: an expression of the netlist language over what the study sets,
/// `slaves * clusters <= 16`. There `master.trials` is `trials`, and in what is compared with a clock or the speed of a
/// link 20M is 20 million.
class StudyCondition {
public:
    /// "" always holds. Throws RefusedInput.
    explicit StudyCondition(const std::string& text);
    ~StudyCondition();
    StudyCondition(StudyCondition&&) noexcept;
    StudyCondition& operator=(StudyCondition&&) noexcept;

    /// Throws RefusedInput where it names what the study does not set, or cannot be computed.
    bool holds(const Overrides& set) const;

private:
    struct Parsed;
    std::unique_ptr<Parsed> parsed_; ///< none: always
};

} // namespace placedpar
