#pragma once

#include "gaprocs/policies/individual.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_observer.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// The state from which a search process continues after a generation.
struct SearchCheckpoint {
    SearchState search;
    std::uint64_t populations = 0;         ///< hash of all generations so far
    Individual best;                       ///< fittest of all generations so far
    std::vector<Improvement> improvements; ///< from the first generation to the one that had `best`

    friend bool operator==(const SearchCheckpoint&, const SearchCheckpoint&) = default;
};

/// Keeps the states of all searches of a run, so that a later run can continue from them. The later run skips the
/// generations that the first run has made. Until the generation of their checkpoint, the searches of the later run
/// receive the same samples of measurements, but evaluate, exchange and breed nothing. From there, their generations
/// equal the generations of an unbroken run, bit for bit. If islands exchange individuals asynchronously, the
/// generations may differ, because the checkpoints do not store emigrants that are under way.
///
/// The functions may be called by several threads at once.
class Checkpoints {
public:
    /// Returns the checkpoint from which the search of this name continues. Returns null if the search starts from the
    /// beginning. The checkpoint exists until the end of the run.
    virtual const SearchCheckpoint* begin_of(const std::string& search) const = 0;
    /// Returns whether searches must call keep() after this generation.
    virtual bool is_due(std::uint64_t generation) const = 0;
    virtual void keep(const std::string& search, const SearchCheckpoint&) = 0;

protected:
    ~Checkpoints() = default;
};

} // namespace placedpar
