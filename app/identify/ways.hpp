#pragma once

#include "app/exit_code.hpp"
#include "app/options/identify_options.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar {

class RecordPieces; // app/identify/record_pieces.hpp
namespace hydraulics {
class Record; // hydraulics/data/record.hpp
}

// These are the ways in which `placedpar identify` evaluates a record. Each prints its results, adds them to
// `json`, and throws RefusedInput, UserError or UnfitRecord.

/// Runs one search over the first transient, as in chapter 3 of the thesis. If a netlist is given, also runs the same
/// search as processes of the netlist.
ExitCode identify_by_thesis(const IdentifyOptions& options, boost::json::object& json);
/// Runs one search for several links over the whole movement (identification/whole_search.hpp), and prints the least
/// standard error that the record's noise allows, and the cost on T800s.
ExitCode identify_over_whole(const IdentifyOptions& options, boost::json::object& json);
/// Evaluates all movements, as the monitor identifies and judges them. Without a configuration, calls
/// identify_moving() if configurations can be recognised from the record, and otherwise assumes configuration a.
ExitCode identify_as_service(const IdentifyOptions& options, boost::json::object& json);
/// Recognises the configuration of each sample, and searches with a population for each set of Figure 3.13.
ExitCode identify_moving(const IdentifyOptions& options, hydraulics::Record first, RecordPieces& pieces,
                         boost::json::object& json);
/// Evaluates all records as identify_as_service() does, and prints how the compliance of each link changes.
ExitCode identify_trend(const IdentifyOptions& options, boost::json::object& json);

} // namespace placedpar
