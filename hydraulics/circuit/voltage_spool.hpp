#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// Returns the spool position, in inches, that a voltage at the boom's servo-valve demands (equation A.1). The position
/// rises strictly with the voltage. The function holds only while the boom rises; the thesis gives no function for
/// lowering.
double desired_spool_in(double volts);

/// Returns the voltage with which a controller demands a spool position: the inverse of A.1, accurate to the last few
/// bits. Throws std::invalid_argument if the spool is below 0 or not finite.
double servo_volts(double spool_in);

/// A simulated fault: an offset that grows with time. Its causes may be a worn spool, the servo-valve's pressure
/// regulation, or the sensors of spool and voltage (thesis 2.3.2).
struct OffsetDrift {
    double at_start = 0;   ///< in the unit of the quantity to which the offset is added
    double rate_per_s = 0; ///< in the unit of at_start, per second

    double at(double time_s) const { return at_start + rate_per_s * time_s; }
};

/// The spool position over the voltage for a worn machine: equation A.1 with offsets in voltage and position.
struct DriftedVoltageSpool {
    OffsetDrift volts;
    OffsetDrift spool_in;

    /// Returns the spool position, at least 0. The program assumes that the spool's travel ends at 0.
    double desired_spool_in(double volts_commanded, double time_s) const;
};

/// The motion of the spool towards its desired position (A.2): a first-order lag. The solution is exact if the command
/// is constant during each sampling period T: Spool(k) = Desired(k-1) (1 - e) + e Spool(k-1) with e = exp(-a_0 T). The
/// thesis prints k instead of k-1 in both terms. With Desired(k) the spool would move one period early, and an
/// identified compliance would be wrong by 17 %.
class SpoolLag {
public:
    /// Throws std::invalid_argument unless lag and period are above 0.
    SpoolLag(double lag_per_s, double period_s, double spool_in);

    double spool_in() const { return spool_in_; }
    /// Advances by `periods` sampling periods, during which the desired position is `desired_in`.
    void hold(double desired_in, double periods = 1) {
        double kept = periods == 1 ? kept_ : std::pow(kept_, periods);
        spool_in_ = desired_in * (1 - kept) + kept * spool_in_;
    }

private:
    double kept_; ///< e
    double spool_in_;
};

/// Returns the spool position at each sampling instant of the voltages, for a machine without a sensor of the spool
/// (experiment 2 of thesis 3.1.3). Before the first instant, the spool is at rest at the position for the first
/// voltage. Throws what SpoolLag throws.
std::vector<double> spool_from_volts(std::span<const double> volts, double lag_per_s, double period_s,
                                     const DriftedVoltageSpool& = {});
/// Returns the spool position for voltages with gaps: at instants that are whole numbers of periods apart. During a gap
/// the command is the last voltage before the gap, which is exact if the true command was constant. REQUIRES: one
/// instant for each voltage, in rising order.
std::vector<double> spool_from_volts(std::span<const double> volts, std::span<const double> time_s, double lag_per_s,
                                     double period_s, const DriftedVoltageSpool& = {});

} // namespace placedpar::hydraulics
