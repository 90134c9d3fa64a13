#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/diagnosis_state.hpp"
#include "monitor/protocol/message.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// The on-line diagnoses of all machines (excavators), by the machine's name.
class Diagnoses {
public:
    Diagnoses(const identification::DiagnosisSettings& settings, std::uint64_t seed, std::size_t most)
        : settings_(settings), seed_(seed), most_(most) {}

    const identification::DiagnosisSettings& settings() const { return settings_; }
    std::uint64_t seed() const { return seed_; }
    const std::map<std::string, identification::Diagnosis>& all() const { return diagnoses_; }
    /// REQUIRES: the machine is known.
    identification::Diagnosis& named(const std::string& machine) { return diagnoses_.at(machine); }

    /// Returns the diagnosis of the machine that the hello names. A hello is the first message of a client. The client
    /// is the control system of the machine, or only watches the diagnosis. The hello of a control system creates the
    /// diagnosis of a new machine; the hello of a watcher does not. Throws BadMessage, and changes nothing, if a
    /// watcher names an unknown machine, if the machine is known with other parameters, or if there are too many
    /// machines.
    identification::Diagnosis& greet(const Hello& hello);
    /// Adds a diagnosis from the state file.
    void add(identification::Diagnosis::State state);

    bool knows(const std::string& machine) const { return diagnoses_.contains(machine); }
    bool full() const { return diagnoses_.size() >= most_; }
    /// REQUIRES: no reference to the diagnosis of this machine is in use.
    void forget(const std::string& machine) { diagnoses_.erase(machine); }

    /// Processes a message from the state file again after a restart. The message is a configuration, a sample or a
    /// baseline (compliances of the healthy links) of a known machine. Throws BadMessage or
    /// identification::RefusedSample.
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
