#pragma once

#include "explore/identify/ways.hpp"

namespace placedpar {

/// Chooses the way of identification (IdentifySettings::way), that is, how an excavator's fluid compliances are found
/// in a record, if none was given. Throws UserError for numbers out of range, and for settings that have no effect in
/// this way.
void settle_way(IdentifySettings&);
/// Returns the option with the way, for messages: "--way whole"; for a default, "--way service (the default)".
/// REQUIRES: settle_way() has chosen the way.
std::string shown_way(const IdentifySettings&);

/// Evaluates a record in the way that the settings name. Throws RefusedInput, UserError or UnfitRecord. REQUIRES:
/// settle_way() has chosen the way.
IdentifyEnd identify_record(const IdentifySettings&, const RecordInput&, const IdentifyOutput&);

} // namespace placedpar
