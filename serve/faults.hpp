#pragma once

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar::serve {

/// Checks a netlist, a configuration or a program in occam. Returns an array of {"severity", "message", "hint", "file",
/// "line", "column", "others"}. Lines and columns count from 1, a column counts bytes, and line 0 means the file as a
/// whole. Each of the others has "message", "file", "line" and "column".
boost::json::array faults_json(const std::string& main);

} // namespace placedpar::serve
