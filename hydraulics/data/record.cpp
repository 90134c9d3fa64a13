#include "hydraulics/data/record.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

struct SensorName {
    std::string_view name;
    Quantity quantity;
};

constexpr std::array sensors{
    SensorName{"inlet_pressure", Quantity::pressure}, // in the order of Sensor
    SensorName{"outlet_pressure", Quantity::pressure},
    SensorName{"angle", Quantity::angle},
    SensorName{"spool", Quantity::length},
    SensorName{"servo", Quantity::voltage},
    SensorName{"inlet_area", Quantity::area},
    SensorName{"bypass_area", Quantity::area},
};

} // namespace

std::string_view name_of(Sensor sensor) { return sensors[static_cast<std::size_t>(sensor)].name; }

Quantity quantity_of(Sensor sensor) { return sensors[static_cast<std::size_t>(sensor)].quantity; }

std::optional<Sensor> sensor_named(std::string_view name) {
    for (Sensor each : all_sensors)
        if (name == name_of(each))
            return each;
    return std::nullopt;
}

LinkSet Record::links() const {
    LinkSet measured;
    for (Link link : all_links)
        if (std::ranges::any_of(all_sensors, [&](Sensor sensor) { return has(link, sensor); }))
            measured.insert(link);
    return measured;
}

ChannelSet Record::channels() const {
    ChannelSet there;
    for (Link link : all_links)
        for (Sensor sensor : all_sensors)
            if (has(link, sensor))
                there.insert(link, sensor);
    return there;
}

bool ChannelSet::contains(const ChannelSet& all) const {
    return std::ranges::all_of(all_links, [&](Link link) {
        return std::ranges::all_of(
            all_sensors, [&](Sensor sensor) { return contains(link, sensor) || !all.contains(link, sensor); });
    });
}

std::vector<Stretch> Record::stretches() const {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < size(); ++i)
        if (i == 0 || time_s[i] - time_s[i - 1] > 1.5 * period_s)
            stretches.push_back({i, i + 1});
        else
            stretches.back().last = i + 1;
    return stretches;
}

std::optional<SensorReading> first_unmeasurable(const Record& record) {
    for (std::size_t i = 0; i < record.size(); ++i)
        for (Link link : all_links)
            for (Sensor sensor : all_sensors)
                if (record.has(link, sensor) && !(std::abs(record.of(link, sensor)[i]) <= largest_reading))
                    return SensorReading{link, sensor, record.time_s[i], record.of(link, sensor)[i]};
    return std::nullopt;
}

} // namespace placedpar::hydraulics
