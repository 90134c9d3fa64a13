#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// Returns the spool position, in inches, that a servo-valve voltage demands: the boom's voltage-spool function A.1.
/// The function is strictly increasing for every voltage. It holds for raising only; the thesis gives no function for
/// lowering.
double desired_spool_in(double volts);

/// Returns the voltage for a spool position, as a controller does: the inverse of A.1, accurate to the last few bits.
/// Throws std::invalid_argument if the spool is below 0 or not finite.
double servo_volts(double spool_in);

/// An offset that grows with time. Causes are a worn spool, the servo-valve's pressure regulation, or the sensors that
/// measured spool and voltage (2.3.2). With rate 0 the offset is constant.
struct OffsetDrift {
    double at_start = 0;   ///< in the unit of the quantity to which it is added
    double rate_per_s = 0; ///< in the unit of at_start, per second

    double at(double time_s) const { return at_start + rate_per_s * time_s; }
};

/// A voltage-spool function that has drifted away from A.1.
struct DriftedVoltageSpool {
    OffsetDrift volts;
    OffsetDrift spool_in;

    /// Returns the spool position. It is at least 0, where we assume that the spool's travel ends.
    double desired_spool_in(double volts_commanded, double time_s) const;
};

/// The dynamics of the spool, A.2: a first-order lag, exact for a command that is held over each sampling period.
/// Spool(k) = Desired(k-1) (1 - e) + e Spool(k-1) with e = exp(-a_0 T). The thesis prints k instead of k-1 in both
/// terms. With Desired(k) the spool would move one period early, and an identified compliance would be wrong by 17 %.
class SpoolLag {
public:
    /// Throws std::invalid_argument unless lag and period are above 0.
    SpoolLag(double lag_per_s, double period_s, double spool_in);

    double spool_in() const { return spool_in_; }
    /// Advances by one period, or several, with the command `desired_in`.
    void hold(double desired_in, double periods = 1) {
        double kept = periods == 1 ? kept_ : std::pow(kept_, periods);
        spool_in_ = desired_in * (1 - kept) + kept * spool_in_;
    }

private:
    double kept_; ///< e
    double spool_in_;
};

/// Returns the spool at each sampling instant of the voltages. Before the first instant, the spool is at rest at the
/// position for the first voltage (experiment 2 of 3.1.3). Throws what SpoolLag throws.
std::vector<double> spool_from_volts(std::span<const double> volts, double lag_per_s, double period_s,
                                     const DriftedVoltageSpool& = {});
/// Returns the spool position at instants that are whole numbers of periods apart, as in a record. Over a gap the last
/// command before the gap is held, which is exact if the command was constant. REQUIRES: one instant for each voltage,
/// in rising order.
std::vector<double> spool_from_volts(std::span<const double> volts, std::span<const double> time_s, double lag_per_s,
                                     double period_s, const DriftedVoltageSpool& = {});

} // namespace placedpar::hydraulics
