#pragma once

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "monitor/protocol/message.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::monitor {

/// The last readings of one link, from which the derivatives come: the line through 5 samples belongs to the
/// middle one, so that what comes out is 2 samples old.
class LinkTrack {
public:
    /// Plain values, oldest first.
    struct State {
        std::vector<double> inlet_psi, angle_deg, inlet_in2, bypass_in2;
        std::optional<double> spool_in, desired_in; // of the spool that is followed from its voltage
    };

    LinkTrack() = default;
    explicit LinkTrack(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }

    /// `elapsed_s` since the reading before, above 0; none when that is not known: a spool that is followed from its
    /// voltage is at rest then.
    void push(const Reading& reading, const LinkParameters& parameters, std::optional<double> elapsed_s);
    /// Forgets the readings. The spool moves on, whatever the circuit and the samples do.
    void restart();

    /// Of the middle one of the last 5 samples; none while there are fewer.
    std::optional<hydraulics::LinkSample> centre(const hydraulics::CentredLineFit& fit,
                                                 const LinkParameters& parameters) const;

private:
    double follow_spool_in(double servo_V, const LinkParameters& parameters, std::optional<double> elapsed_s);

    State state_;
};

} // namespace placedpar::monitor
