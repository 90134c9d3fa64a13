#pragma once

#include "gaprocs/islands.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/workload.hpp"
#include "runtime/channel.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

class ProcessEnvironment;

/// Exchanges individuals between an island process and its neighbours: the exchange of Islands (gaprocs/islands.hpp) by
/// messages.
///
/// In step, a process for each channel sends or receives, all in parallel, and the exchange ends when all of them have
/// ended. No topology can deadlock: every island makes its exchanges in the same order, each with all of its channels
/// at once (P. Welch's I/O-PAR). Which channels are used in an exchange follows from the topology and the schedule, so
/// both ends know it.
///
/// Asynchronous: for each neighbour, one process sends and another receives into a letter box, both at high priority
/// beside the search. The search hands emigrants to each sender that is idle, and empties the boxes. Receivers are
/// always ready, so that no sender waits for long. An island that ends tells its neighbours.
class IslandExchange {
public:
    /// REQUIRES: the process is an island of the environment's network, which has passed check_islands().
    IslandExchange(const ProcessEnvironment&, const SearchProblem&, const SearchSettings&, const Workload&);

    /// Returns the number of samples needed before the first generation; for islands in step, enough for each of them.
    std::size_t samples_to_begin() const { return samples_to_begin_; }
    /// Returns whether an exchange is due after the evaluation of this generation.
    bool is_due(std::uint64_t generation) const { return has_neighbours_ && schedule_.is_due(generation); }
    /// Returns whether the island, with or without neighbours, reports its best to an analyst after this generation.
    bool reports_after(std::uint64_t generation) const { return schedule_.is_due(generation); }
    /// Runs the search; if the exchange is asynchronous, in parallel with the processes that send and receive.
    void beside_mail(const std::function<void()>& search);
    /// Sends the emigrants that are due and returns the immigrants in the order in which they are to be accepted.
    /// Immigrants from an island with another window are evaluated again in this one, at the cost of the error
    /// evaluations. REQUIRES: is_due(search.generation() + 1).
    std::vector<Migration> exchange(Search&, std::span<const double> fitness, std::span<const Sample> window);
    const Acceptance& acceptance() const { return acceptance_; }
    /// Returns the process name of an island. REQUIRES: immigrants come from it.
    const std::string& name_of(std::size_t island) const;

private:
    struct Outgoing {
        std::size_t to;
        Output<Emigrants> output;
        bool idle = true; ///< asynchronous: the last letter has been sent
        Channel<InPlace<Emigrants>> letters;

        Outgoing(std::size_t island, Output<Emigrants> end, const std::string& process)
            : to(island), output(end), letters("letters of " + process) {}
    };
    struct Incoming {
        std::size_t from;
        std::string process; ///< name of the sending process
        Input<Emigrants> input;
        std::vector<std::size_t> its_neighbours;
        bool other_window; ///< the sender's window differs from this island's
        Emigrants last;    ///< last emigrants received, if not yet accepted
    };

    Emigrants leaving(Search&, std::span<const double> fitness) const;
    void exchange_in_step(const Emigrants&, std::uint64_t generation);
    void exchange_by_mail(const Emigrants&);
    std::vector<Migration> take_arrivals();
    void evaluate_arrivals(std::span<Migration>, std::span<const Sample> window) const;
    void send_letters(Outgoing&);
    void receive_letters(Incoming&);

    std::shared_ptr<const Archipelago> archipelago_; ///< kept alive for the islands that begin after this one
    const SearchProblem& problem_;
    double bias_;
    Workload workload_;
    Schedule schedule_;
    Emigration emigration_;
    Acceptance acceptance_;
    std::size_t self_ = 0; ///< this island's number
    std::vector<std::size_t> neighbours_;
    bool has_neighbours_ = false;
    std::size_t samples_to_begin_ = 0;
    std::vector<std::unique_ptr<Outgoing>> outgoing_;
    std::vector<std::unique_ptr<Incoming>> incoming_; ///< in the order of island numbers
};

} // namespace placedpar
