#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/flag.hpp"

#include <boost/json/fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Returns a line of text with a compliance and its standard error, first in in^3/psi and then in m^3/Pa: "C_BOi
/// 0.00850 0.00004 2.019e-11 8.7e-14".
std::string print_compliance(std::string_view name, double compliance_in3_per_psi, double standard_error_in3_per_psi);
/// Returns the heading of the columns of print_compliance().
std::string compliance_heading();

/// Returns a line for each flag; each line begins with `!` and the compliance's name.
std::string print_flags(std::string_view name, const std::vector<identification::Flag>& flags);
boost::json::array flags_json(const std::vector<identification::Flag>& flags);

/// Returns null if the number is missing or not finite.
boost::json::value or_null(std::optional<double> number);

} // namespace placedpar
