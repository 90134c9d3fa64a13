#pragma once

#include "workbench/explain/critical_path.hpp"
#include "workbench/explain/what_if.hpp"

#include <boost/json.hpp>

#include <string>
#include <vector>

namespace placedpar {

/// Why a run took as long as it did.
struct Explanation {
    RunReport report;
    std::map<std::string, Account> accounts; ///< by process
    std::vector<PathPart> path;
    std::vector<Answer> answers; ///< the greatest gain first
};

/// For people.
std::string print_explanation(const Explanation&, const Network&);
/// The same for machines; times in picoseconds.
boost::json::object explanation_json(const Explanation&, const Network&);

} // namespace placedpar
