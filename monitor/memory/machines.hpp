#pragma once

#include "identification/on_line/machine.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// All machines under diagnosis, by name.
class Machines {
public:
    Machines(const DiagnosisSettings& settings, std::uint64_t seed, std::size_t most)
        : settings_(settings), seed_(seed), most_(most) {}

    const DiagnosisSettings& settings() const { return settings_; }
    std::uint64_t seed() const { return seed_; }
    const std::map<std::string, Machine>& all() const { return machines_; }
    /// REQUIRES: it is known.
    Machine& named(const std::string& name) { return machines_.at(name); }

    /// A control system makes the machine known, a watcher needs one that is. Throws BadMessage, having changed
    /// nothing, also when the machine is known with other parameters.
    Machine& greet(const Hello& hello);
    /// From the state file.
    void add(Machine::State state);

    /// Takes a message of which a record was made: a hello, or one for a known machine. Throws BadMessage.
    void replay(const std::string& machine, std::string_view message);

private:
    DiagnosisSettings settings_;
    std::uint64_t seed_;
    std::size_t most_;
    std::map<std::string, Machine> machines_;
};

} // namespace placedpar::monitor
