#pragma once

#include "monitor/memory/diagnoses.hpp"
#include "monitor/memory/journal.hpp"

#include <boost/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Keeps what is known of all machines over a restart: the state file, written whole, and beside it a journal
/// (FILE.journal) of the messages taken since, as they came.
///
/// 1. A diagnosis is a function of its messages: taking the journal's again gives the same state to the bit.
/// 2. Writing the state file begins a new epoch. A journal of an older epoch is already in the state file and is not
///    read, so that a kill between the two steps loses and repeats nothing.
class StateStore {
public:
    /// A journal longer than either goes into the state file: a restart would have to do it all again.
    static constexpr std::size_t most_journal_bytes = 8u << 20;
    static constexpr std::uint64_t most_generations = 20000; ///< one to five seconds of work

    /// Takes the lock. Throws UserError, naming the path, when it is no file, cannot be opened, or another program has
    /// it.
    explicit StateStore(std::filesystem::path path);

    /// Reads what there is, and writes it as a new epoch. Gives a sentence for people, empty when there was nothing.
    /// Throws UserError naming the file when it is no state file, or was written with other settings.
    std::string restore(Diagnoses& diagnoses);

    /// To be called before the message is answered. `generations` is what it cost. Throws UserError when it cannot be
    /// appended. From then on, until write() has succeeded, does nothing: the journal has a hole.
    void record(const std::string& machine, std::string_view message, std::size_t generations);
    /// The journal has lost something on its way to the disk: it has a hole, as if a message had not been appended.
    void journal_failed() { complete_ = false; }
    /// Would a restart give all that has been recorded?
    bool complete() const { return complete_; }
    /// Is it time to write()? The journal is long, or has a hole.
    bool due() const { return !complete_ || journal_.bytes() > most_journal_bytes || generations_ > most_generations; }
    /// Brings the whole state file to the disk and empties the journal. Throws UserError, or what std::filesystem does;
    /// then state file and journal are as before, or the state file is the new one.
    void write(const Diagnoses& diagnoses);
    /// The journal to the disk; safe from another thread.
    void sync() const { journal_.sync(); }

private:
    void read_state_file(Diagnoses& diagnoses);
    void take_state(const boost::json::value& state, Diagnoses& diagnoses);
    void read_journal(Diagnoses& diagnoses, std::string& said);

    std::filesystem::path path_;
    Journal journal_;
    std::uint64_t epoch_ = 0;
    std::uint64_t generations_ = 0; ///< in the journal
    bool complete_ = true;
};

} // namespace placedpar::monitor
