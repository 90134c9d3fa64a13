#pragma once

#include "explore/study/expression.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

/// What the names in a table's expressions stand for.
class FigureNames {
public:
    /// `meaning` says what it is: "the row above".
    void add(const std::string& name, const std::string& meaning) { meanings_[name].insert(meaning); }
    /// "master.trials" is also "trials", unless something else that is set is called so.
    void add_settings(const Overrides&);
    void add_measures(const std::vector<std::string>&);

    /// Throws UserError for a name in it that stands for nothing, or for several things. `other`: more names.
    void require(const StudyExpression&, const FigureNames& other) const;

private:
    std::map<std::string, std::set<std::string>> meanings_;
};

} // namespace placedpar
