#pragma once

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::identification {

/// Keeps the last samples of one link, and computes how fast pressure and angle change. A sample is the mean of some
/// readings. The slope of a line fitted to 5 samples belongs to the middle sample, so centre() is 2 samples old.
class LinkTrack {
public:
    /// The sums of the readings of a sample that is not complete yet.
    struct Sums {
        double inlet_psi = 0, angle_deg = 0;
        double spool_in = 0;                  ///< measured, or computed from the voltage
        double inlet_in2 = 0, bypass_in2 = 0; ///< areas, if they are read
        std::size_t readings = 0;
        bool areas = false; ///< whether areas are read

        friend bool operator==(const Sums&, const Sums&) = default;
    };

    /// Each list holds the last samples, oldest first.
    struct State {
        std::vector<double> inlet_psi, angle_deg, inlet_in2, bypass_in2;
        /// The actual and the desired spool position, if they are computed from the voltage.
        std::optional<double> spool_in, desired_in;
        Sums sums;

        friend bool operator==(const State&, const State&) = default;
    };

    LinkTrack() = default;
    explicit LinkTrack(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }
    friend bool operator==(const LinkTrack&, const LinkTrack&) = default;

    /// Adds a reading. `elapsed_s` is the time since the previous reading, above 0. If this time is unknown, a spool
    /// whose position is computed from the voltage is assumed to be at rest.
    void read(const Reading& reading, const hydraulics::LinkConstants& constants, std::optional<double> elapsed_s);
    /// Makes a sample, the mean of the readings since the last sample. If some readings have areas and others spool
    /// positions, the sample has the kind that was read last. REQUIRES: there is a reading.
    void finish_sample();
    /// Forgets the readings. Keeps the spool position computed from voltages, because the spool moves on during a gap
    /// or a change of the circuit.
    void restart();

    /// Returns the middle sample of the last 5, with its rates of change; nullopt while there are fewer samples.
    std::optional<hydraulics::LinkSample> centre(const hydraulics::CentredLineFit& fit,
                                                 const hydraulics::LinkConstants& constants) const;

    /// The newest sample. `piston_in3` is the volume behind the piston, counted from angle 0.
    struct Newest {
        double inlet_psi, inlet_in2, bypass_in2, piston_in3;
    };
    /// REQUIRES: finish_sample() has been called since the last restart().
    Newest newest(const hydraulics::LinkConstants& constants) const;

    /// Returns whether the middle sample of the last 5 stands out from the others, as only a faulty reading does; false
    /// while there are fewer samples.
    bool spikes(double period_s) const;

private:
    void add_valve(const Reading& reading, const hydraulics::LinkConstants& constants, std::optional<double> elapsed_s);
    double follow_spool_in(double servo_V, const hydraulics::LinkConstants& constants, std::optional<double> elapsed_s);

    State state_;
};

} // namespace placedpar::identification
