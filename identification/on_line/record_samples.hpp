#pragma once

#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>

namespace placedpar::identification {

/// What is read of a link in a record, as a control system would tell it.
struct LinkReader {
    hydraulics::AreasFrom from = hydraulics::AreasFrom::spool;
    double spool_offset_in = 0; ///< by which the spool reads too high
};

/// The links of which there is what a diagnosis needs: inlet pressure, angle, and one of areas, spool and voltage.
hydraulics::LinkSet links_to_diagnose(const hydraulics::ChannelSet& there);

/// The readings of these links at one instant of a record. Spools and areas below 0 are noise of a sensor at 0.
/// REQUIRES: the record has them.
ExcavatorSample sample_of(const hydraulics::Record& record, std::size_t index, hydraulics::LinkSet links,
                          const hydraulics::PerLink<LinkReader>& readers);

} // namespace placedpar::identification
