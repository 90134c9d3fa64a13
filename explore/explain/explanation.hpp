#pragma once

#include "explore/explain/what_if.hpp"
#include "observe/critical_path/critical_path.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <vector>

namespace placedpar {

/// Explains why a run took as long as it did.
struct Explanation {
    RunReport report;
    std::map<std::string, Account> accounts; ///< by process name: what the process spent its time on
    /// Time that senders waited for receivers. The key is one direction of a link, "a.link[0] -> b.link[1]".
    std::map<std::string, Time> waits_at_links;
    std::vector<PathPart> path;
    bool path_too_long = false;  ///< the critical path was too long to keep
    std::vector<Answer> answers; ///< effects of changes, in the order of try_out()
    std::size_t left_out = 0;    ///< number of changes that an interruption left untried
    std::string not_tried = "";  ///< why no change was tried although changes were asked for; "" otherwise
};

/// Returns the explanation as text for readers.
std::string print_explanation(const Explanation&, const Network&);
/// Returns the explanation as JSON; times are in picoseconds.
boost::json::object explanation_json(const Explanation&, const Network&);

} // namespace placedpar
