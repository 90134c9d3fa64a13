#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace placedpar {

class RankMail; // ranks/rank_mail.hpp

/// The ranks of an MPI program: mpirun starts copies of this program, on one machine or many, and each has a number,
/// its rank. Ranks send each other texts. The texts from one rank to another arrive in the order in which they were
/// sent.
///
/// REQUIRES: used only by the thread that called ranks_of_mpirun(), and not destroyed while another rank may still send
/// a message to this rank.
class Ranks {
public:
    struct Message {
        int from;
        std::string text;
    };

    virtual ~Ranks() = default;
    virtual int own() const = 0;
    virtual int count() const = 0;
    virtual void send(int to, const std::string& text) = 0;
    /// Returns the next message that has arrived; nothing if there is none.
    virtual std::optional<Message> receive() = 0;
    /// Opens a mail: a faster way to send bytes than send() is for texts. All ranks must call this function the same
    /// number of times and in the same order. REQUIRES: the mail is closed before the ranks are destroyed.
    virtual std::unique_ptr<RankMail> open_mail() = 0;
};

/// The pause between two checks for messages.
inline constexpr std::chrono::milliseconds rank_patience{4};

/// Waits for the next message, and returns it.
Ranks::Message wait_for_message(Ranks&);

/// Returns the ranks with which mpirun, or Slurm's srun, started this program; null if neither started it. Throws
/// UserError if this PlacedPar was built without MPI.
///
/// MPI is loaded by this call, as a separate module (app/mpi), so that a program without ranks does not need MPI.
std::unique_ptr<Ranks> ranks_of_mpirun();

/// Returns the path of the module (app/mpi): beside the program, or in the folder of the installation. Returns an empty
/// path if neither exists.
std::filesystem::path module_of_ranks();

/// Ends a command that several ranks cannot share. If there are several ranks, throws UserError in rank 0 and returns
/// true in the other ranks, which must then end silently.
bool left_to_rank_zero(const std::string& command);

/// Prepares the same work in all ranks. `prepare` returns a digest of what the rank has prepared, which must be the
/// same in all ranks. Returns true if all ranks have prepared the same. Otherwise returns false in the ranks above 0,
/// which must then end silently. Rank 0 rethrows what its own `prepare` threw, or throws UserError with the number of
/// the rank that failed or differs. REQUIRES: all ranks call this function.
bool all_prepared(Ranks&, const std::function<std::string()>& prepare);

} // namespace placedpar
