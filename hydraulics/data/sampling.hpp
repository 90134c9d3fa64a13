#pragma once

#include "hydraulics/data/record.hpp"

#include <cstddef>

namespace placedpar::hydraulics {

/// The thesis samples every 20 ms. The methods of identification, such as slopes over five samples, are designed for
/// about this period.
inline constexpr double method_period_s = 0.020;

/// States how fast readings become slower samples for identification. Each sample is the mean of `readings` successive
/// readings. The number is chosen so that the period of the samples is near method_period_s.
struct Sampling {
    double reading_s = method_period_s; ///< time between two readings
    std::size_t readings = 1;           ///< number of readings per sample

    /// Chooses the number of readings per sample for readings that are `reading_s` apart. Throws UnfitRecord, with the
    /// reason, if the readings are too slow or too fast.
    static Sampling of(double reading_s);

    double period_s() const { return reading_s * static_cast<double>(readings); }
    /// Returns the number of samples that last about `duration_s`, at least one.
    std::size_t samples_in(double duration_s) const;
};

/// Returns the rate of readings at this period as a text: "1 kHz", "50 Hz".
std::string rate_text(double period_s);
/// Returns a text such as "1 kHz averaged to 50 Hz, 20 readings each".
std::string print_sampling(const Sampling&);

/// Returns the record with its readings averaged to samples. The time of a sample is the middle of its readings. A
/// sample combines only readings between the same two gaps. Readings before a gap that do not fill a sample are
/// dropped. The equations take a voltage as constant from one sample's time to the next sample's time. Therefore a
/// sample's voltage is the mean of the readings between these two times. The configuration of a sample is that of its
/// middle reading.
Record averaged(const Record& record, const Sampling& sampling);

} // namespace placedpar::hydraulics
