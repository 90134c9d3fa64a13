#pragma once

#include "explore/study/expression.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

/// The meanings of the names in the expressions of a study's table, by which wrong and ambiguous names are found.
class FigureNames {
public:
    /// `meaning` describes in messages what the name stands for: "the row above".
    void add(const std::string& name, const std::string& meaning) { meanings_[name].insert(meaning); }
    /// Adds the settings. "master.trials" is also called "trials", unless another setting has that name.
    void add_settings(const Overrides&);
    void add_measures(const std::vector<std::string>&);

    /// Throws UserError if a name in the expression has no meaning in this object and `other`, or several meanings.
    void require(const StudyExpression&, const FigureNames& other) const;

private:
    std::map<std::string, std::set<std::string>> meanings_;
};

} // namespace placedpar
