#pragma once

#include "explore/identify/ways.hpp"
#include "text/diagnostic.hpp"

#include <string_view>
#include <vector>

namespace placedpar {

class Interruption; // explore/netlist_run.hpp

/// Returns a record of measurements that is read from a text of comma-separated values in memory. When the text is
/// read, warnings are appended to `warnings`, and an error is thrown as a RefusedText. After an interruption the record
/// ends. REQUIRES: the text, the interruption and the warnings outlive the record.
RecordInput record_of_text(std::string_view text, const Interruption&, std::vector<Diagnostic>& warnings);

} // namespace placedpar
