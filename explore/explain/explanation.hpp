#pragma once

#include "explore/explain/what_if.hpp"
#include "observe/critical_path/critical_path.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <vector>

namespace placedpar {

/// The causes of the time that a run took.
struct Explanation {
    RunReport report;
    std::map<std::string, Account> accounts; ///< key: process
    /// Time that sending processes waited for receiving processes, for each direction of a link, "a.link[0] ->
    /// b.link[1]".
    std::map<std::string, Time> waits_at_links;
    std::vector<PathPart> path;
    bool path_too_long = false;  ///< the path was not kept because it is too long
    std::vector<Answer> answers; ///< the greatest gain first
    std::size_t left_out = 0;    ///< changes that an interruption left untried
    std::string not_tried = "";  ///< why no change was tried although changes were asked for; "" otherwise
};

/// Returns the explanation as text for readers.
std::string print_explanation(const Explanation&, const Network&);
/// Returns the explanation as JSON; times are in picoseconds.
boost::json::object explanation_json(const Explanation&, const Network&);

} // namespace placedpar
