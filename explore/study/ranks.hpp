#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace placedpar {

/// The ranks of an MPI program: mpirun starts copies of this program, on one machine or many, and each has a number,
/// its rank. They send each other texts, which come in the order in which they were sent.
///
/// REQUIRES: used only by the thread that asked for it, and destroyed after the last message to this rank.
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
    /// The next message that has come; none if none has.
    virtual std::optional<Message> receive() = 0;
};

/// How long to leave the processor to others before looking for messages again.
inline constexpr std::chrono::milliseconds rank_patience{4};

/// Those among which mpirun, or Slurm's srun, started this program; null where neither did. Throws UserError where this
/// PlacedPar was built without MPI.
///
/// MPI is loaded only now, as a module of its own (app/mpi): who does not start ranks need not have it.
std::unique_ptr<Ranks> ranks_of_mpirun();

/// For work that ranks cannot share, and would all do: throws UserError in rank 0 of several, and is true in the
/// others, which have nothing to do nor to say.
bool left_to_rank_zero(const std::string& command);

} // namespace placedpar
