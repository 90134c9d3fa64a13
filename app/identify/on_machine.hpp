#pragma once

#include "app/exit_code.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>

namespace placedpar {

struct ProcessSearch; // explore/process_search.hpp
namespace identification {
struct AnswerInTime;     // identification/transient_search.hpp
struct ComplianceSearch; // identification/compliance_search.hpp
struct Identified;       // identification/identification.hpp
} // namespace identification

/// Identifies compliances by processes on simulated transputers. Prints the run, the answers of all searches after each
/// sample, the fittest answer, how far the searches agree, and the simulated seconds that the transputers took. Adds
/// all of these to `json`. `native` is the answer of identify(), which computes without simulated transputers. A single
/// search must make the same generations as identify(). If its answer differs, returns `missed_tolerance`. Several
/// searches make other generations; their answer is only printed beside the native answer.
ExitCode run_on_machine(const ProcessSearch& search, const identification::Identified& native,
                        const identification::ComplianceSearch& prepared, std::uint64_t seed,
                        boost::json::object& json);

/// Runs an identification as run_on_machine() does, without printing. Also computes when the answer would be ready if
/// the samples came from sensors, one every `period_s`. The run itself takes samples as fast as it can, except if a
/// process of the kind ga.sensors sends them at their times. For the time of the answer, each sample takes as long as
/// in the run. The work on a sample begins when the sample has been taken and the work on the preceding sample has
/// ended. Throws UserError if the run gives no answer, or if the period of ga.sensors differs from `period_s`.
identification::AnswerInTime answer_in_time(const ProcessSearch& search,
                                            const identification::ComplianceSearch& prepared, double period_s,
                                            std::uint64_t seed);

} // namespace placedpar
