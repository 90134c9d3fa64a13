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

/// What an island process sends to its neighbours and gets from them: the exchange of Islands (gaprocs/islands.hpp),
/// by messages.
///
/// In step, all emigrants go out and all immigrants come in at the same time, as parallel processes, and the exchange
/// is over when all have. No topology can deadlock: every island makes its exchanges in the same order, each with all
/// of its channels at once (P. Welch's I/O-PAR). Which channels are used in an exchange follows from the topology and
/// the schedule, so both ends know it.
///
/// Asynchronous: for each neighbour a process sends, and a process receives into a letter box, both at high priority
/// beside the search. The search hands its emigrants over where the last ones have gone, and empties the box. Receivers
/// always receive, so that nothing waits for long. Each island ends by telling its neighbours so.
class IslandExchange {
public:
    /// REQUIRES: the process is an island of the environment's network, which has passed check_islands().
    IslandExchange(const ProcessEnvironment&, const SearchProblem&, const SearchSettings&, const Workload&);

    /// How many samples must be there for the first generation: where islands are in step, for that of each of them.
    std::size_t samples_to_begin() const { return samples_to_begin_; }
    /// Is an exchange due after the evaluation of this generation?
    bool is_due(std::uint64_t generation) const { return has_neighbours_ && schedule_.is_due(generation); }
    /// Does it report its best to an analyst after this generation? Whether or not it has neighbours.
    bool reports_after(std::uint64_t generation) const { return schedule_.is_due(generation); }
    /// Runs the search, beside the processes that send and receive where it does not wait for them.
    void beside_mail(const std::function<void()>& search);
    /// Sends the emigrants that are due and returns the immigrants in the order in which they are to be accepted.
    /// Those from another window are evaluated in this one, which costs the error evaluations.
    /// REQUIRES: is_due(search.generation() + 1).
    std::vector<Migration> exchange(Search&, std::span<const double> fitness, std::span<const Sample> window);
    const Acceptance& acceptance() const { return acceptance_; }
    /// The process of an island from which immigrants come, by its number. REQUIRES: it is one.
    const std::string& name_of(std::size_t island) const;

private:
    struct Outgoing {
        std::size_t to;
        Output<Emigrants> output;
        bool idle = true; ///< asynchronous: the last letter has gone
        Channel<InPlace<Emigrants>> letters;

        Outgoing(std::size_t island, Output<Emigrants> end, const std::string& process)
            : to(island), output(end), letters("letters of " + process) {}
    };
    struct Incoming {
        std::size_t from;
        std::string process; ///< its name
        Input<Emigrants> input;
        std::vector<std::size_t> its_neighbours;
        bool other_window; ///< than this island's
        Emigrants last;    ///< received and not accepted yet
    };

    Emigrants leaving(Search&, std::span<const double> fitness) const;
    void exchange_in_step(const Emigrants&, std::uint64_t generation);
    void exchange_by_mail(const Emigrants&);
    std::vector<Migration> take_arrivals();
    void evaluate_arrivals(std::span<Migration>, std::span<const Sample> window) const;
    void send_letters(Outgoing&);
    void receive_letters(Incoming&);

    std::shared_ptr<const Archipelago> archipelago_; ///< held for the islands that begin after this one
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
    std::vector<std::unique_ptr<Incoming>> incoming_; ///< from the island of lowest number first
};

} // namespace placedpar
