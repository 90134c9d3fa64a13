#pragma once

#include "hydraulics/data/record.hpp"

#include <cstddef>

namespace placedpar::hydraulics {

/// The thesis samples every 20 ms: slopes over five samples, windows and movements are made for about that.
inline constexpr double method_period_s = 0.020;

/// How readings become the samples that identification is made for: each is the mean of so many readings in
/// succession, none is dropped, and the samples are as near to method_period_s apart as whole readings allow.
struct Sampling {
    double reading_s = method_period_s; ///< from one reading to the next
    std::size_t readings = 1;           ///< that make a sample

    /// Throws UnfitRecord, with the reason, for readings that are too slow or too quick.
    static Sampling of(double reading_s);

    double period_s() const { return reading_s * static_cast<double>(readings); }
    /// So many samples are nearest to this time, at least one.
    std::size_t samples_in(double duration_s) const;
};

/// "1 kHz", "50 Hz": of readings so far apart.
std::string rate_text(double period_s);
/// "1 kHz averaged to 50 Hz, 20 readings each".
std::string print_sampling(const Sampling&);

/// The record's readings as such samples; each stands at the middle of its readings. A sample holds no readings from
/// both sides of a gap, and what is left over before one is left out. A voltage is what is held from one sample to the
/// next: the mean of the readings between their middles.
Record averaged(const Record& record, const Sampling& sampling);

} // namespace placedpar::hydraulics
