#pragma once

#include "explore/identify/identify_settings.hpp"
#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/record_table.hpp"
#include "hydraulics/data/sampling.hpp"
#include "text/diagnostic.hpp"

#include <boost/json/fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

// The ways to identify compliances (ways.hpp) use these functions.

/// Reads links of the excavator, such as the boom, by name, separated by commas. Throws UserError for an unknown link,
/// and for a link that is named twice.
hydraulics::LinkSet links_of(const std::string& links);

/// Replaces the settings of a way of identification by the settings that the user gave. Way: DiagnosisSettings or
/// IdentificationWay.
template <class Way>
void change_way(Way& way, const IdentifySettings& given) {
    way.bits = given.bits.value_or(way.bits);
    way.search.elite = given.elite.value_or(way.search.elite);
    way.search.population = given.population.value_or(way.search.population);
    way.search.window.trials = given.trials.value_or(way.search.window.trials);
    way.search.window.length = given.window.value_or(way.search.window.length);
    way.search.window.bias = given.bias;
}

std::optional<hydraulics::AreasFrom> areas_asked(const IdentifySettings& settings);
hydraulics::Side side_asked(const IdentifySettings& settings);
/// Reads a number of inches. Throws UserError for anything else.
double offset_asked(const std::string& text);
/// Returns the channels of the record that each link needs: the pressure of the chosen side, the angle, and the
/// channels from which the areas of the valve's orifices are computed (hydraulics::AreasFrom). The settings `columns`
/// and `columns_from` give the names of the record's columns. `links` is a function that receives the channels of the
/// record, and returns the links to identify.
hydraulics::RecordNeeds needs_of(const IdentifySettings& settings,
                                 std::function<hydraulics::LinkSet(const hydraulics::ChannelSet&)> links);

/// Returns a description of how the record's readings were averaged.
boost::json::object sampling_json(const hydraulics::Sampling& sampling);
boost::json::array warnings_json(const std::vector<Diagnostic>& warnings);

} // namespace placedpar
