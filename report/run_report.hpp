#pragma once

#include "gaprocs/generation_log.hpp"
#include "report/manifest.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

struct RunReport; // netlist/run_report.hpp

/// Prints the report for people: how the run ended, what the processes measured, the generations of the searches, and
/// how busy each part was.
std::string print_report(const RunReport&, const Network&, const GenerationLog& = GenerationLog({}));
/// Returns the report for programs, with all that is needed to repeat the run.
boost::json::object report_json(const RunReport&, const Network&, const Manifest&,
                                const GenerationLog& = GenerationLog({}));

} // namespace placedpar
