#pragma once

#include "netlist/read.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>

namespace placedpar {

/// An expression of the netlist language over what a study sets, `slaves * clusters <= 16`, and over figures of its
/// runs. There `master.trials` is `trials`, and in what is compared with a clock or the speed of a link 20M is 20
/// million. Copies are the same expression, which one thread at a time may evaluate.
class StudyExpression {
public:
    /// Numbers by their names, which settings of these names hide.
    using Figures = std::map<std::string, double>;

    /// "" is none. Throws RefusedInput.
    explicit StudyExpression(const std::string& text);

    explicit operator bool() const { return parsed_ != nullptr; }
    /// The names in it, whether they stand for something or not.
    std::set<std::string> names() const;
    /// None always holds. Throws RefusedInput where it names what is neither set nor a figure, or cannot be computed.
    bool holds(const Overrides& set) const;
    /// Throws RefusedInput as holds(), and where it is not a number. REQUIRES: it is not none.
    double value(const Overrides& set, const Figures&) const;

private:
    struct Parsed;
    template <class Read>
    void evaluate(const Overrides&, const Figures&, Read) const;

    std::shared_ptr<Parsed> parsed_; ///< none: ""
};

} // namespace placedpar
