#pragma once

#include "netlist/read.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>

namespace placedpar {

/// An expression of the netlist language, as a study uses it for conditions and table entries. Its names are settings
/// of a study, as in `slaves * clusters <= 16`, or figures of the study's runs. The setting `master.trials` is called
/// `trials`. In a comparison with a clock or the speed of a link, 20M is 20 million. Copies share the parsed
/// expression, so only one thread at a time may evaluate an expression or its copies.
class StudyExpression {
public:
    /// Numbers by name. A setting with the name of a figure takes precedence.
    using Figures = std::map<std::string, double>;

    /// Parses the expression; "" gives an empty expression. Throws RefusedInput.
    explicit StudyExpression(const std::string& text);

    explicit operator bool() const { return parsed_ != nullptr; }
    /// Returns the names in the expression, known or not.
    std::set<std::string> names() const;
    /// Returns whether the expression holds with these settings; an empty expression always holds. Throws RefusedInput
    /// if a name is not a setting, or the value cannot be computed.
    bool holds(const Overrides& set) const;
    /// Returns the value. Throws RefusedInput as holds() does, and if the value is not a number. REQUIRES: the
    /// expression is not empty.
    double value(const Overrides& set, const Figures&) const;

private:
    struct Parsed;
    template <class Read>
    void evaluate(const Overrides&, const Figures&, Read) const;

    std::shared_ptr<Parsed> parsed_; ///< null for an empty expression
};

} // namespace placedpar
