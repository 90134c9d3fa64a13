#pragma once

#include "monitor/memory/journal.hpp"
#include "monitor/memory/machines.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Keeps what is known of all machines over a restart: the state file, written whole, and beside it a journal
/// (FILE.journal) of the messages taken since, as they came. The diagnosis is a function of its messages, so
/// that taking those of the journal again gives the state at the last of them to the bit.
///
/// Writing the state file whole begins a new epoch; a journal of an older epoch is already in the state file,
/// so that a kill between the two steps loses and repeats nothing.
class StateStore {
public:
    /// Journals longer than either are written into the state file: what a restart has to do again.
    static constexpr std::size_t most_journal_bytes = 8u << 20;
    static constexpr std::uint64_t most_generations = 20000; // one to five seconds of work

    /// Takes the lock. Throws std::runtime_error.
    explicit StateStore(std::filesystem::path path);

    /// Reads what there is, and writes it as a new epoch. Gives a sentence for people, empty when there was nothing.
    /// Throws std::runtime_error naming the file when it is no state file, or of other settings than the machines'.
    std::string restore(Machines& machines);

    /// Before the message is answered. `generations` is what it cost. Throws std::runtime_error when it cannot be
    /// appended. From then on it does nothing, since what came would come behind a hole, until write() has succeeded.
    void record(const std::string& machine, std::string_view message, std::size_t generations);
    /// The journal lost something on its way to the disk, as if a message of it had not been appended.
    void journal_failed() { complete_ = false; }
    /// A restart would give all that has been recorded.
    bool complete() const { return complete_; }
    /// It is time to write(): the journal is long, or has a hole.
    bool due() const { return !complete_ || journal_.bytes() > most_journal_bytes || generations_ > most_generations; }
    /// The state file, whole, on the disk; the journal empty. Throws std::runtime_error; then the state file and the
    /// journal are those before it, or the state file is the new one.
    void write(const Machines& machines);
    /// The journal to the disk; safe from another thread.
    void sync() const { journal_.sync(); }

private:
    void read_state_file(Machines& machines);
    void read_journal(Machines& machines, std::string& said);

    std::filesystem::path path_;
    Journal journal_;
    std::uint64_t epoch_ = 0;
    std::uint64_t generations_ = 0; // in the journal
    bool complete_ = true;
};

} // namespace placedpar::monitor
