#pragma once

#include "explore/identify/ways.hpp"
#include "text/diagnostic.hpp"

#include <string_view>
#include <vector>

namespace placedpar {

class Interruption; // explore/netlist_run.hpp

/// Returns a record that is read from a text of comma-separated values in memory. Warnings about the text are appended
/// to `warnings`; an error is thrown as a RefusedText when the text is read. After an interruption the record ends.
/// REQUIRES: the text, the interruption and the warnings outlive the record.
RecordInput record_of_text(std::string_view text, const Interruption&, std::vector<Diagnostic>& warnings);

} // namespace placedpar
