#include "identification/on_line/record_samples.hpp"

#include "identification/on_line/population_sets.hpp"

#include <algorithm>
#include <optional>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

Reading reading_of(const Record& record, std::size_t index, Link link, const LinkReader& reader) {
    auto read = [&](Sensor sensor) { return record.of(link, sensor)[index]; };
    Reading reading{read(Sensor::inlet_pressure), read(Sensor::angle), {}};
    switch (reader.from) {
    case AreasFrom::areas:
        reading.valve = ValveAreas{std::max(read(Sensor::inlet_area), 0.0), std::max(read(Sensor::bypass_area), 0.0)};
        break;
    case AreasFrom::spool:
        reading.valve = SpoolPosition{std::max(read(Sensor::spool) - reader.spool_offset_in, 0.0)};
        break;
    case AreasFrom::servo: reading.valve = ServoVoltage{read(Sensor::servo)}; break;
    }
    return reading;
}

} // namespace

LinkSet links_to_diagnose(const ChannelSet& there) {
    LinkSet links;
    for (Link link : all_links)
        if (there.contains(channels_needed(link, areas_from(there, link, std::nullopt))))
            links.insert(link);
    return links;
}

ExcavatorSample sample_of(const Record& record, std::size_t index, LinkSet links, const PerLink<LinkReader>& readers) {
    ExcavatorSample sample{record.time_s[index], {}};
    for (Link link : links_of(links))
        sample.links[index_of(link)] = reading_of(record, index, link, readers[index_of(link)]);
    return sample;
}

} // namespace placedpar::identification
