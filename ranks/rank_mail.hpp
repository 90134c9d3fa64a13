#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// A message of at most RankMail::longest_letter bytes.
struct RankLetter {
    int from;
    std::span<const std::uint8_t> bytes; ///< valid until the next RankMail::receive()
};

/// A message of any length. The two ranks agree on its number, to tell parcels apart.
struct RankParcel {
    int from;
    int number;
    std::vector<std::uint8_t> bytes;
};

/// Sends bytes between ranks, that is, copies of the program that mpirun started. Messages of different mails, and
/// texts of Ranks, are kept apart. No function waits.
///
/// A letter is a short message, which is copied. Any rank may send a letter to any rank at any time. Letters from one
/// rank to another arrive in the order in which they were sent. A parcel is not copied: the receiver states in advance
/// which parcel it expects, so that MPI can write into the receiver's memory. Parcels from one rank to another with the
/// same number arrive in the order in which they were sent.
///
/// REQUIRES: only the thread that opened the mail uses it. Before the mail is closed, every letter has been received,
/// and every parcel has been expected.
class RankMail {
public:
    /// The most bytes of a letter. Open MPI sends a message of this length at once, without waiting for a reply of the
    /// receiver.
    static constexpr std::size_t longest_letter = 4000;

    /// The most bytes of a parcel. MPI counts the bytes of a message in an int.
    static constexpr std::size_t longest_parcel = std::numeric_limits<int>::max();

    virtual ~RankMail() = default;
    virtual int own() const = 0;
    virtual int count() const = 0;
    /// Returns the number of ranks on this computer.
    virtual int count_here() const = 0;

    virtual void send(int to, std::span<const std::uint8_t> letter) = 0;
    /// Returns the next letter that has arrived; nothing if there is none.
    virtual std::optional<RankLetter> receive() = 0;

    /// REQUIRES: number >= 0.
    virtual void send_parcel(int to, int number, std::vector<std::uint8_t>) = 0;
    /// Prepares memory for a parcel of this length. The receiver calls this function before it can receive the parcel.
    virtual void expect_parcel(int from, int number, std::size_t bytes) = 0;
    /// Returns a parcel that was expected and has arrived; nothing if there is none.
    virtual std::optional<RankParcel> receive_parcel() = 0;
    /// Returns whether no expected parcel is missing.
    virtual bool has_all_parcels() const = 0;
};

} // namespace placedpar
