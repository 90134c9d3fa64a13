#pragma once

#include "netlist/machine.hpp"
#include "workbench/manifest.hpp"

#include <boost/json.hpp>

#include <string>

namespace placedpar {

/// For people: how the run ended, what the processes measured, how busy everything was.
std::string print_report(const RunReport&, const Network&);
/// The same for machines, with what is needed to run it again.
boost::json::object report_json(const RunReport&, const Network&, const Manifest&);

} // namespace placedpar
