#pragma once

#include "hydraulics/data/link.hpp"
#include "hydraulics/data/units.hpp"
#include "text/user_error.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// The quantities measured at a link.
enum class Sensor : unsigned char {
    inlet_pressure,  ///< psi: P_i, the pump side
    outlet_pressure, ///< psi: P_o, the drain side
    angle,           ///< deg, of the joint
    spool,           ///< in
    servo,           ///< V, at the servo-valve
    inlet_area,      ///< in^2: a_i, for links whose areas cannot be computed from the spool's position
    bypass_area      ///< in^2: a_e
};

inline constexpr std::array<Sensor, 7> all_sensors{Sensor::inlet_pressure, Sensor::outlet_pressure, Sensor::angle,
                                                   Sensor::spool,          Sensor::servo,           Sensor::inlet_area,
                                                   Sensor::bypass_area};

constexpr Sensor pressure_sensor(Side side) {
    return side == Side::inlet ? Sensor::inlet_pressure : Sensor::outlet_pressure;
}

/// Returns "inlet_pressure" and so on, as in the header of a record's file: boom.inlet_pressure [psi].
std::string_view name_of(Sensor);
Quantity quantity_of(Sensor);
std::optional<Sensor> sensor_named(std::string_view);

/// A set of sensors of links.
class ChannelSet {
public:
    bool contains(Link link, Sensor sensor) const { return there_[index_of(link)][static_cast<std::size_t>(sensor)]; }
    bool contains(const ChannelSet& all) const;
    void insert(Link link, Sensor sensor) { there_[index_of(link)][static_cast<std::size_t>(sensor)] = true; }

private:
    PerLink<std::array<bool, all_sensors.size()>> there_{};
};

/// Consecutive samples, [first, last).
struct Stretch {
    std::size_t first, last;
};

/// Measurements of an excavator's motion, from which compliances are identified. A channel is one sensor of one link.
/// All channels are read at the same instants, which are a fixed period apart except at gaps.
class Record {
public:
    std::string description;
    double period_s = 0;
    /// The instants in rising order. INVARIANT: two successive instants are a whole number of periods apart, within
    /// sampling_tolerance.
    std::vector<double> time_s;
    /// The true configuration of the main valve at each instant: 'a' to 'e', or '-' if unknown. Empty if the record has
    /// no configurations.
    std::string configuration;

    std::size_t size() const { return time_s.size(); }
    /// Returns one value for each instant, in the unit of the sensor's quantity; empty if the sensor is not in the
    /// record.
    const std::vector<double>& of(Link link, Sensor sensor) const {
        return channels_[index_of(link)][static_cast<std::size_t>(sensor)];
    }
    std::vector<double>& of(Link link, Sensor sensor) {
        return channels_[index_of(link)][static_cast<std::size_t>(sensor)];
    }
    bool has(Link link, Sensor sensor) const { return !of(link, sensor).empty(); }
    /// Returns the links with at least one sensor in the record.
    LinkSet links() const;
    ChannelSet channels() const;

    /// Returns the parts of the record between its gaps.
    std::vector<Stretch> stretches() const;

private:
    std::array<std::array<std::vector<double>, all_sensors.size()>, all_links.size()> channels_;
};

/// Reports a record that lacks data for an identification. what() states what is missing, but does not name the record.
class UnfitRecord : public UserError {
public:
    using UserError::UserError;
};

/// A limit above all possible measurements, in any unit of units.hpp. Below this limit, slopes and squares of readings
/// stay finite.
inline constexpr double largest_reading = 1e12;

struct SensorReading {
    Link link;
    Sensor sensor;
    double time_s, value;
};

/// Returns the earliest reading that is not finite or is beyond largest_reading. If several readings at this instant
/// are such, returns the reading of the first channel.
std::optional<SensorReading> first_unmeasurable(const Record& record);

/// The largest distance of a sample from its regular instant, as a share of the period.
inline constexpr double sampling_tolerance = 0.02;

} // namespace placedpar::hydraulics
