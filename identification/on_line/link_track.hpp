#pragma once

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/inputs.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::identification {

/// The last samples of one link, each the mean of some readings, and their slopes: a line through 5 of them gives the
/// slope at the middle one, so that centre() is 2 samples old.
class LinkTrack {
public:
    /// The readings of the sample that is not whole yet, added up.
    struct Sums {
        double inlet_psi = 0, angle_deg = 0;
        double spool_in = 0;                  ///< as it is read or followed,
        double inlet_in2 = 0, bypass_in2 = 0; ///< or the areas as they are read
        std::size_t readings = 0;
        bool areas = false; ///< are read

        friend bool operator==(const Sums&, const Sums&) = default;
    };

    /// Plain values, oldest first.
    struct State {
        std::vector<double> inlet_psi, angle_deg, inlet_in2, bypass_in2;
        std::optional<double> spool_in, desired_in; ///< of the spool that is followed from its voltage
        Sums sums;

        friend bool operator==(const State&, const State&) = default;
    };

    LinkTrack() = default;
    explicit LinkTrack(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }
    friend bool operator==(const LinkTrack&, const LinkTrack&) = default;

    /// `elapsed_s` is the time since the reading before, above 0. When it is not known, a spool that is followed from
    /// its voltage, reading by reading, is taken to be at rest.
    void read(const Reading& reading, const hydraulics::LinkConstants& constants, std::optional<double> elapsed_s);
    /// The readings since the last sample are one: their mean. Those of areas and of a spool do not mix: the later kind
    /// counts. REQUIRES: there is one.
    void finish_sample();
    /// Forgets the readings, but not the spool, which moves on over a gap or a change of circuit.
    void restart();

    /// The middle one of the last 5 samples; none while there are fewer.
    std::optional<hydraulics::LinkSample> centre(const hydraulics::CentredLineFit& fit,
                                                 const hydraulics::LinkConstants& constants) const;

    /// Does the middle one stand out from the others? No while there are fewer.
    bool spikes(double period_s) const;

private:
    void add_valve(const Reading& reading, const hydraulics::LinkConstants& constants, std::optional<double> elapsed_s);
    double follow_spool_in(double servo_V, const hydraulics::LinkConstants& constants, std::optional<double> elapsed_s);

    State state_;
};

} // namespace placedpar::identification
