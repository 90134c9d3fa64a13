#pragma once

#include "gaprocs/generation_log.hpp"
#include "report/manifest.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

struct RunReport; // netlist/run_report.hpp

/// For people: how the run ended, what the processes measured, what the generations of those that search were like, how
/// busy everything was.
std::string print_report(const RunReport&, const Network&, const GenerationLog& = GenerationLog({}));
/// The same for machines, with what is needed to run it again.
boost::json::object report_json(const RunReport&, const Network&, const Manifest&,
                                const GenerationLog& = GenerationLog({}));

} // namespace placedpar
