#pragma once

#include <functional>

namespace placedpar::identification {
struct AnswerInTime;     // identification/transient_search.hpp
struct ComplianceSearch; // identification/compliance_search.hpp
} // namespace placedpar::identification

namespace placedpar::monitor {

/// Searches all samples of a movement, which are `period_s` apart, by the processes of a netlist. Throws
/// std::exception, which says why there is no answer.
using NetlistSearch = std::function<identification::AnswerInTime(identification::ComplianceSearch, double period_s)>;

} // namespace placedpar::monitor
