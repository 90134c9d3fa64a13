#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace placedpar {

class RankMail; // ranks/rank_mail.hpp

/// The ranks of an MPI program. mpirun starts copies of this program, on one computer or many. Each copy is a rank, and
/// has a number. Ranks send each other texts. The texts from one rank to another arrive in the order in which they were
/// sent.
///
/// REQUIRES: only the thread that called ranks_of_mpirun() uses the object. It is not destroyed while another rank may
/// still send to this rank.
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
    /// Opens a mail, which sends bytes faster than send() sends texts. REQUIRES: all ranks call this function equally
    /// often, in the same order; the mail is closed before this object is destroyed.
    virtual std::unique_ptr<RankMail> open_mail() = 0;
};

/// The pause between two checks for a message in wait_for_message().
inline constexpr std::chrono::milliseconds rank_patience{4};

/// Waits for the next message, and returns it.
Ranks::Message wait_for_message(Ranks&);

/// Returns the ranks with which mpirun, or Slurm's srun, started this program; null if neither started it. Throws
/// UserError if this PlacedPar was built without MPI.
///
/// This call loads MPI, as a separate module (app/mpi), so that a program without ranks does not need MPI.
std::unique_ptr<Ranks> ranks_of_mpirun();

/// Returns the path of the module (app/mpi): beside the program, or in the folder of the installation. Returns an empty
/// path if neither exists.
std::filesystem::path module_of_ranks();

/// Is for a command that several ranks cannot share. If there are several ranks, throws UserError in rank 0, and
/// returns true in the other ranks, which must then end silently. Returns false if there is only one.
bool left_to_rank_zero(const std::string& command);

/// Checks before shared work that all ranks have read the same input. `prepare` reads the input, and returns a hash or
/// text that identifies it. Returns true if the results of all ranks are equal. Otherwise returns false in the ranks
/// above 0, which must then end silently. Rank 0 then rethrows what its own `prepare` threw, or throws UserError with
/// the number of the rank that failed or differs. REQUIRES: all ranks call this function.
bool all_prepared(Ranks&, const std::function<std::string()>& prepare);

} // namespace placedpar
