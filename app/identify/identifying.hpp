#pragma once

#include "app/options/identify_options.hpp"
#include "hydraulics/data/record_table.hpp"
#include "identification/on_line/record_diagnosis.hpp"
#include "identification/whole_search.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Identifies the compliances in a record that is read in pieces, as the monitor does it.
class Identifying {
public:
    /// Throws UserError for a wrong setting or a question that the first piece cannot answer.
    Identifying(const IdentifyOptions& options, const hydraulics::Record& first);

    hydraulics::LinkSet links() const { return links_; }
    const identification::DiagnosisSettings& settings() const { return settings_; }
    const identification::Diagnosis& diagnosis() const { return diagnosis_.diagnosis(); }

    /// Returns the movements that end in the piece.
    std::vector<identification::MovementFinding> take(const hydraulics::Record& piece) {
        return diagnosis_.take(piece);
    }
    std::vector<identification::MovementFinding> end() { return diagnosis_.end(); }

private:
    identification::DiagnosisSettings settings_;
    hydraulics::LinkSet links_;
    identification::RecordDiagnosis diagnosis_;
};

identification::DiagnosisSettings settings_of(const IdentifyOptions& options);
/// Returns whether the configuration of a record with these channels is to be recognised.
bool moves(const IdentifyOptions& options, const hydraulics::ChannelSet& there);
/// Returns the channels that a record must have.
hydraulics::RecordNeeds needs_of_service(const IdentifyOptions& options);
/// Returns how a machine whose configuration is recognised is identified.
identification::WholeWay moving_way(const IdentifyOptions& options, std::size_t links);
/// Throws UnfitRecord: no movement was found.
[[noreturn]] void refuse_rest(const Identifying& identifying);

} // namespace placedpar
