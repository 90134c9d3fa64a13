#pragma once

#include "explore/study/study.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/parameter_coding.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// The machines among which a search finds the best: a study's combinations of settings. Each machine is identified by
/// its number in the study's product. A genome has a field of bits for each setting that has several values. The codes
/// of the field are spread evenly over these values.
class MachineSpace {
public:
    /// Throws UserError if the study has several products, which a genome cannot code, only one machine, or more
    /// machines than 64 bits can count. REQUIRES: the study outlives this object, and has a product.
    explicit MachineSpace(const Study&);

    /// Counts all machines, including machines for which the study's condition does not hold.
    std::uint64_t count() const { return count_; }
    /// Returns whether the study's condition holds for the machine.
    bool holds(std::uint64_t machine) const { return product_.where.holds(settings(machine)); }
    Overrides settings(std::uint64_t machine) const { return product_.at(machine); }

    /// Returns the names of the settings that have several values.
    std::vector<std::string> names() const;
    /// Returns the settings that are equal in all machines.
    Overrides fixed() const;

    std::size_t bits() const { return coding_.bits(); }
    /// REQUIRES: the genome has bits() bits.
    std::uint64_t machine_of(const Genome&) const;

private:
    const StudyProduct& product_;
    std::uint64_t count_;
    ParameterCoding coding_;
};

} // namespace placedpar
