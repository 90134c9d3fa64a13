#pragma once

#include "explore/identify/identify_settings.hpp"
#include "explore/load.hpp"
#include "hydraulics/data/record_table.hpp"
#include "identification/on_line/record_diagnosis.hpp"
#include "identification/whole_search.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Identifies the compliances of an excavator's hydraulics in a record that is read in pieces, as the program `monitor`
/// does.
class Identifying {
public:
    /// Throws UserError for a wrong setting, or if the first piece of the record lacks channels (measured quantities)
    /// that the settings need. `warn` receives warnings about the machine's constants.
    Identifying(const IdentifySettings& settings, const hydraulics::Record& first, const WarningSink& warn);

    hydraulics::LinkSet links() const { return links_; }
    const identification::DiagnosisSettings& settings() const { return settings_; }
    const identification::Diagnosis& diagnosis() const { return diagnosis_.diagnosis(); }

    /// Evaluates the next piece. Returns the movements of the machine that end in this piece.
    std::vector<identification::MovementFinding> take(const hydraulics::Record& piece) {
        return diagnosis_.take(piece);
    }
    std::vector<identification::MovementFinding> end() { return diagnosis_.end(); }

private:
    identification::DiagnosisSettings settings_;
    hydraulics::LinkSet links_;
    identification::RecordDiagnosis diagnosis_;
};

identification::DiagnosisSettings settings_of(const IdentifySettings& settings);
/// Returns whether the machine's configuration (which links move) must be recognised from a record with these channels.
bool moves(const IdentifySettings& settings, const hydraulics::ChannelSet& there);
/// Returns the channels that a record must have.
hydraulics::RecordNeeds needs_of_service(const IdentifySettings& settings);
/// Returns the way of identifying a machine whose configuration is recognised.
identification::WholeWay moving_way(const IdentifySettings& settings, std::size_t links);
/// Throws UserError if a setting was given that needs a configuration.
void require_no_fixed_settings(const IdentifySettings& settings);
/// Returns the excavator's links whose compliance is wanted from a record whose configuration is recognised.
hydraulics::LinkSet links_that_move(const IdentifySettings& settings);
/// Throws UnfitRecord, which says why no movement was found.
[[noreturn]] void refuse_rest(const Identifying& identifying);

} // namespace placedpar
