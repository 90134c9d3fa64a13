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

/// Runs an identification as processes of a simulated machine. Prints the run, the answers of all searches after each
/// sample, the fittest answer, how far the searches agree, and the seconds that the machine took. Adds all of these to
/// `json`. A single search makes the same generations as identify(), so `missed_tolerance` is returned if its answer
/// differs from the native answer. Several searches make other generations, so their answer is only printed beside the
/// native answer.
ExitCode run_on_machine(const ProcessSearch& search, const identification::Identified& native,
                        const identification::ComplianceSearch& prepared, std::uint64_t seed,
                        boost::json::object& json);

/// Runs an identification as run_on_machine() does, without printing. The run takes samples as fast as it can, unless
/// ga.sensors reads them. The time of the answer is computed for a machine that needs as much time for each sample as
/// in the run. Such a machine cannot begin a sample before the sample is taken, nor before it has finished the
/// preceding sample. Throws UserError if there is no answer, or if the period of ga.sensors differs from `period_s`.
identification::AnswerInTime answer_in_time(const ProcessSearch& search,
                                            const identification::ComplianceSearch& prepared, double period_s,
                                            std::uint64_t seed);

} // namespace placedpar
