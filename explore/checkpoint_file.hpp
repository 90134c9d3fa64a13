#pragma once

#include "gaprocs/checkpoints.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// A search whose state is stored, with the parameters that must not change between two runs.
struct KeptSearch {
    std::string search;
    std::map<std::string, std::string> parameters;
};

/// A file with the states of all searches of a run at one generation, from which a later run continues. The file is
/// replaced as a whole, so it is never partly written. If searches end at different generations, the file has the last
/// generation that all of them have reached.
class CheckpointFile final : public Checkpoints {
public:
    /// Reads the file if it exists; the searches then continue from it. `every` is the number of generations between
    /// two stored states, at least 1.
    ///
    /// Throws UserError if a search of the network depends on data that a checkpoint cannot store. Such a search sends
    /// estimates, or belongs to a pair of a coarse and a fine search. Throws UserError if no process searches. Throws
    /// UserError if the file cannot be read, is not a checkpoint, has another seed, or has searches with other names,
    /// problems, codings or numbers of individuals. Other parameters may have changed: the searches continue with the
    /// new values.
    CheckpointFile(std::filesystem::path, const Network&, std::uint64_t seed, std::uint64_t every);
    /// Makes a checkpoint file for searches that a program runs without a netlist, such as run_islands().
    CheckpointFile(std::filesystem::path, std::vector<KeptSearch>, std::uint64_t seed, std::uint64_t every);

    /// Returns the generation from which the searches continue; 0 if they begin anew.
    std::uint64_t begin() const { return begin_; }

    /// Returns a text that identifies the searches' start and the generations whose states are stored. Two objects have
    /// equal texts only if their searches continue from the same file and store the same generations.
    std::string digest() const;

    const SearchCheckpoint* begin_of(const std::string& search) const override;
    bool is_due(std::uint64_t generation) const override { return generation % every_ == 0; }
    /// Writes the file when all searches have handed over their states of a generation. Throws UserError if the file
    /// cannot be written.
    void keep(const std::string& search, const SearchCheckpoint&) override;

private:
    using States = std::map<std::string, SearchCheckpoint>; ///< key: name of the search

    static std::vector<KeptSearch> describe(const Network&);
    [[noreturn]] void refuse_file(const std::string& why) const;
    void read();
    void take(const boost::json::value& file);
    void require_same_run(const boost::json::value& file) const;
    void write(const States&) const;

    std::filesystem::path path_;
    std::uint64_t seed_, every_;
    std::vector<KeptSearch> searches_;
    std::uint64_t begin_ = 0;
    std::int64_t checksum_ = 0; ///< checksum of the file that was read; 0 if no file was read
    States begin_states_;
    std::mutex mutex_;
    std::map<std::uint64_t, States> incomplete_; ///< key: generation
};

} // namespace placedpar
