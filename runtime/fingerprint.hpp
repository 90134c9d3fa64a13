#pragma once

#include <cstdint>

namespace placedpar {

/// A hash of the communications of a run and the ends of its processes. If two runs have equal fingerprints, the same
/// processes communicated with each other, at the same virtual times and in the same order. Tests compare fingerprints
/// to show that a change of the program does not change its results.
class Fingerprint {
public:
    Fingerprint() = default;
    /// Continues from a value() of another fingerprint.
    explicit Fingerprint(std::uint64_t value) : hash_(value) {}

    void mix(std::uint64_t word) {
        hash_ = (hash_ ^ word) * 0x9e3779b97f4a7c15u; // 2^64 / golden ratio, an odd number without a pattern
        hash_ ^= hash_ >> 32;
    }
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0x243f6a8885a308d3u; // the first digits of pi
};

} // namespace placedpar
