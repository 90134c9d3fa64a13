#pragma once

#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>

namespace placedpar::identification {

/// States how to make from a link's channels in a record the Reading that a control system would report.
struct LinkReader {
    hydraulics::AreasFrom from = hydraulics::AreasFrom::spool;
    double spool_offset_in = 0; ///< amount by which the spool reads too high
};

/// Returns the links whose channels suffice for a diagnosis: inlet pressure, angle, and one of areas, spool and
/// voltage.
hydraulics::LinkSet links_to_diagnose(const hydraulics::ChannelSet& there);

/// Returns the readings of these links at one instant of a record. Spools and areas below 0 become 0, since negative
/// readings are sensor noise. REQUIRES: the record has these readings.
ExcavatorSample sample_of(const hydraulics::Record& record, std::size_t index, hydraulics::LinkSet links,
                          const hydraulics::PerLink<LinkReader>& readers);

} // namespace placedpar::identification
