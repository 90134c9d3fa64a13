// This module passes messages between ranks, the processes of a run that mpirun has started. The program loads this
// module only in such a run (ranks/ranks.hpp).

#include "ranks/expected_parcels.hpp"
#include "ranks/rank_mail.hpp"
#include "ranks/ranks.hpp"

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

namespace mpi = boost::mpi;

/// Returns whether the transfer is complete.
bool is_complete(MPI_Request& request) {
    int complete = 0;
    MPI_Test(&request, &complete, MPI_STATUS_IGNORE);
    return complete != 0;
}

/// Returns a length as an int, as MPI demands. Throws std::length_error if the length does not fit into an int.
int mpi_length(std::size_t bytes) {
    if (!std::in_range<int>(bytes))
        throw std::length_error("a message between ranks has more than 2147483647 bytes");
    return static_cast<int>(bytes);
}

/// Receives letters (messages between ranks) into places in memory that MPI knows in advance. Without such places, MPI
/// would buffer each letter first, and each letter would take several times as long. MPI fills the places in the order
/// of arrival, so only one place at a time is checked.
class MpiMail final : public RankMail {
public:
    explicit MpiMail(const mpi::communicator& world) : own_world_(world, mpi::comm_duplicate) {
        for (Place& place : places_)
            MPI_Recv_init(place.bytes.data(), longest_letter, MPI_BYTE, MPI_ANY_SOURCE, letters, own_world_,
                          &place.request);
        for (Place& place : places_)
            MPI_Start(&place.request);
        MPI_Comm here;
        MPI_Comm_split_type(own_world_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
        MPI_Comm_size(here, &count_here_);
        MPI_Comm_free(&here);
    }
    ~MpiMail() override {
        for (Sent& each : sent_)
            MPI_Wait(&each.request, MPI_STATUS_IGNORE);
        for (Place& place : places_) {
            if (&place != in_use_) {
                MPI_Cancel(&place.request);
                MPI_Wait(&place.request, MPI_STATUS_IGNORE);
            }
            MPI_Request_free(&place.request);
        }
    }
    MpiMail(const MpiMail&) = delete;
    MpiMail& operator=(const MpiMail&) = delete;

    int own() const override { return own_world_.rank(); }
    int count() const override { return own_world_.size(); }
    int count_here() const override { return count_here_; }

    void send(int to, std::span<const std::uint8_t> letter) override {
        forget_sent();
        if (spare_.empty())
            spare_.emplace_back();
        Sent& sent = spare_.front();
        sent.bytes.assign(letter.begin(), letter.end());
        MPI_Isend(sent.bytes.data(), mpi_length(letter.size()), MPI_BYTE, to, letters, own_world_, &sent.request);
        if (!is_complete(sent.request)) // happens rarely
            sent_.splice(sent_.end(), spare_, spare_.begin());
    }

    std::optional<RankLetter> receive() override {
        if (Place* const read = std::exchange(in_use_, nullptr))
            MPI_Start(&read->request);
        Place& place = places_[next_];
        int arrived = 0;
        MPI_Status status;
        MPI_Test(&place.request, &arrived, &status);
        if (!arrived)
            return std::nullopt;
        int length = 0;
        MPI_Get_count(&status, MPI_BYTE, &length);
        next_ = (next_ + 1) % places_.size();
        in_use_ = &place;
        return RankLetter{status.MPI_SOURCE, {place.bytes.data(), static_cast<std::size_t>(length)}};
    }

    void send_parcel(int to, int number, std::vector<std::uint8_t> bytes) override {
        forget_sent();
        Sent& sent = sent_.emplace_back();
        sent.bytes = std::move(bytes);
        MPI_Issend(sent.bytes.data(), mpi_length(sent.bytes.size()), MPI_BYTE, to, first_parcel + number, own_world_,
                   &sent.request);
    }

    void expect_parcel(int from, int number, std::size_t bytes) override {
        auto& expected = expected_.add(from, number, bytes);
        MPI_Irecv(expected.parcel.bytes.data(), mpi_length(bytes), MPI_BYTE, from, first_parcel + number, own_world_,
                  &expected.request);
    }

    std::optional<RankParcel> receive_parcel() override {
        return expected_.take([](auto& expected) { return is_complete(expected.request); });
    }

    bool has_all_parcels() const override { return expected_.empty(); }

private:
    static constexpr int letters = 0, first_parcel = 1; ///< MPI's tags

    struct Place {
        std::array<std::uint8_t, longest_letter> bytes;
        MPI_Request request;
    };
    struct Sent {
        std::vector<std::uint8_t> bytes;
        MPI_Request request = MPI_REQUEST_NULL;
    };

    void forget_sent() {
        if (!sent_.empty()) [[unlikely]]
            sent_.remove_if([](Sent& each) { return is_complete(each.request); });
    }

    mpi::communicator own_world_;
    int count_here_ = 1;
    std::array<Place, 32> places_;
    std::size_t next_ = 0;    ///< the place that the next letter fills
    Place* in_use_ = nullptr; ///< the place whose letter is being read
    std::list<Sent> spare_;   ///< memory that the next letters can use
    std::list<Sent> sent_;    ///< messages that MPI has not sent yet
    ExpectedParcels<MPI_Request> expected_;
};

class MpiRanks final : public Ranks {
public:
    int own() const override { return world_.rank(); }
    int count() const override { return world_.size(); }

    void send(int to, const std::string& text) override {
        world_.send(to, tag, text.data(), static_cast<int>(text.size()));
    }

    std::optional<Message> receive() override {
        std::optional<mpi::status> waiting = probe();
        if (!waiting)
            return std::nullopt;
        Message message{waiting->source(), std::string(static_cast<std::size_t>(*waiting->count<char>()), ' ')};
        world_.recv(message.from, tag, message.text.data(), static_cast<int>(message.text.size()));
        return message;
    }

    std::unique_ptr<RankMail> open_mail() override { return std::make_unique<MpiMail>(world_); }

private:
    static constexpr int tag = 0;

    std::optional<mpi::status> probe() {
        auto found = world_.iprobe(mpi::any_source, tag);
        return found ? std::optional(*found) : std::nullopt;
    }

    /// With `false`, an exception in one rank does not abort the other ranks. Instead, the program tells the other
    /// ranks by messages.
    mpi::environment environment_{mpi::threading::funneled, false};
    mpi::communicator world_;
};

} // namespace

} // namespace placedpar

extern "C" placedpar::Ranks* placedpar_mpi_ranks() { return new placedpar::MpiRanks; }
