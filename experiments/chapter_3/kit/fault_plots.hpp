#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "workbench/plot.hpp"

#include <cstdint>
#include <span>

namespace placedpar {

/// The compliance estimated from one record of each machine by the spool, sample by sample; and what a drift of the
/// servo-valve makes of the compliance by the spool and by the voltage, of the first 5 records. REQUIRES: so many
/// seeds.
Plot plot_of_faults(std::span<const Fault> faults, const Plant& plant, std::span<const std::uint64_t> seeds);

} // namespace placedpar
