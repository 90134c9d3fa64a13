#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/protocol/message.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// The diagnoses of all machines, by the machine's name.
class Diagnoses {
public:
    Diagnoses(const identification::DiagnosisSettings& settings, std::uint64_t seed, std::size_t most)
        : settings_(settings), seed_(seed), most_(most) {}

    const identification::DiagnosisSettings& settings() const { return settings_; }
    std::uint64_t seed() const { return seed_; }
    const std::map<std::string, identification::Diagnosis>& all() const { return diagnoses_; }
    /// REQUIRES: there is one of this name.
    identification::Diagnosis& named(const std::string& machine) { return diagnoses_.at(machine); }

    /// The diagnosis that a hello is about. A control system's hello begins one for a new machine; a watcher's does
    /// not. Throws BadMessage, having changed nothing: a machine unknown to a watcher, one known with other parameters,
    /// or one too many.
    identification::Diagnosis& greet(const Hello& hello);
    /// From the state file.
    void add(identification::Diagnosis::State state);

    bool knows(const std::string& machine) const { return diagnoses_.contains(machine); }
    bool full() const { return diagnoses_.size() >= most_; }
    /// REQUIRES: nobody holds on to its diagnosis.
    void forget(const std::string& machine) { diagnoses_.erase(machine); }

    /// Takes a message of the state file again: a configuration, a sample or a baseline of a known machine. Throws
    /// BadMessage or identification::RefusedSample.
    void replay(const std::string& machine, std::string_view message);

private:
    identification::Diagnosis& watched_by(const Hello& hello);
    identification::Diagnosis& controlled_by(const Hello& hello);

    identification::DiagnosisSettings settings_;
    std::uint64_t seed_;
    std::size_t most_;
    std::map<std::string, identification::Diagnosis> diagnoses_;
};

} // namespace placedpar::monitor
