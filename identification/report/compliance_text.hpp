#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/flag.hpp"

#include <boost/json/fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// "C_BOi     0.00850    0.00004  2.019e-11    8.7e-14": a compliance and its standard error in in^3/psi and in m^3/Pa.
std::string print_compliance(std::string_view name, double compliance_in3_per_psi, double standard_error_in3_per_psi);
/// What stands above that.
std::string compliance_heading();

/// A line that begins with ! for each.
std::string print_flags(hydraulics::Link link, const std::vector<identification::Flag>& flags);
boost::json::array flags_json(const std::vector<identification::Flag>& flags);

/// Null where there is none, or it is not finite.
boost::json::value or_null(std::optional<double> number);

} // namespace placedpar
