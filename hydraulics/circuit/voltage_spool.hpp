#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// The boom's voltage-spool function A.1: the spool, in inches, that a servo-valve voltage asks for. Strictly
/// increasing for every voltage. Raising direction only: the thesis gives no function for lowering.
double desired_spool_in(double volts);

/// Its inverse, the spool-voltage function by which a controller finds the voltage; to the last bits.
/// Throws std::invalid_argument when the spool is below 0 or not finite.
double servo_volts(double spool_in);

/// An offset that creeps: a worn spool, a servo-valve's pressure regulation, or the sensor that measured both
/// (2.3.2). Whole from the start when the rate is 0.
struct OffsetDrift {
    double at_start = 0;   ///< in the unit of the quantity that it is added to
    double rate_per_s = 0; ///< that unit per second

    double at(double time_s) const { return at_start + rate_per_s * time_s; }
};

/// A voltage-spool function that has drifted away from A.1.
struct DriftedVoltageSpool {
    OffsetDrift volts;
    OffsetDrift spool_in;

    /// Never below 0, where the spool's travel ends for us.
    double desired_spool_in(double volts_commanded, double time_s) const;
};

/// The spool's dynamics A.2, a first-order lag, exact for a command that is held over each sampling period:
///   Spool(k) = Desired(k-1) (1 - e) + e Spool(k-1),  e = exp(-a_0 T).
/// The thesis prints k in place of both k-1. With Desired(k) the spool would run a period ahead, and the
/// compliance found by it would be 17 % off.
class SpoolLag {
public:
    /// Throws std::invalid_argument unless lag and period are above 0.
    SpoolLag(double lag_per_s, double period_s, double spool_in);

    /// The spool now.
    double spool_in() const { return spool_in_; }
    /// Lets a period pass, or several, in which the command is `desired_in`.
    void hold(double desired_in, double periods = 1) {
        double kept = periods == 1 ? kept_ : std::pow(kept_, periods);
        spool_in_ = desired_in * (1 - kept) + kept * spool_in_;
    }

private:
    double kept_; ///< e
    double spool_in_;
};

/// The spool at each of the voltages' sampling instants, at rest at the first voltage's before them
/// (experiment 2 of 3.1.3). Throws like SpoolLag.
std::vector<double> spool_from_volts(std::span<const double> volts, double lag_per_s, double period_s,
                                     const DriftedVoltageSpool& = {});
/// The same at instants that are whole numbers of periods apart, as a record's are. Over a gap the last command before
/// it is held: exact if it was constant. REQUIRES: as many instants as voltages, rising.
std::vector<double> spool_from_volts(std::span<const double> volts, std::span<const double> time_s, double lag_per_s,
                                     double period_s, const DriftedVoltageSpool& = {});

} // namespace placedpar::hydraulics
