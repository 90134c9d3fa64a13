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

/// Exchanges individuals between an island process and its neighbours, by the rules of Islands (gaprocs/islands.hpp).
///
/// In step, one process for each channel sends or receives. All of them run in parallel, and the exchange ends when the
/// last of them ends. No topology can deadlock: every island makes its exchanges in the same order, and each exchange
/// uses all of its channels in parallel (P. Welch's I/O-PAR). The topology and the schedule determine the channels of
/// an exchange, so both ends of a channel know when it is used.
///
/// In asynchronous exchange, one process for each neighbour sends and another receives into a letter box. Both run at
/// high priority in parallel with the search. The search gives emigrants to each idle sender, and empties the letter
/// boxes. Receivers are always ready, so no sender waits for long. An island that ends sends a last message to its
/// neighbours.
class IslandExchange {
public:
    /// REQUIRES: the process is an island, and its network has passed check_islands().
    IslandExchange(const ProcessEnvironment&, const SearchProblem&, const SearchSettings&, const Workload&);

    /// Returns the number of samples needed before the first generation; in step, the largest number that any island of
    /// the part needs.
    std::size_t samples_to_begin() const { return samples_to_begin_; }
    /// Returns whether an exchange is due after the evaluation of the generation.
    bool is_due(std::uint64_t generation) const { return has_neighbours_ && schedule_.is_due(generation); }
    /// Returns whether the island reports its best to an analyst after the generation. An island without neighbours
    /// reports, too.
    bool reports_after(std::uint64_t generation) const { return schedule_.is_due(generation); }
    /// Runs the search. In asynchronous exchange, runs the sending and receiving processes in parallel with it.
    void beside_mail(const std::function<void()>& search);
    /// Sends the emigrants, and returns the immigrants in the order of acceptance. Immigrants from islands with another
    /// window are evaluated again, which takes computing time. REQUIRES: is_due(search.generation() + 1).
    std::vector<Migration> exchange(Search&, std::span<const double> fitness, std::span<const Sample> window);
    const Acceptance& acceptance() const { return acceptance_; }
    /// Returns the process name of the island. REQUIRES: this island receives immigrants from it.
    const std::string& name_of(std::size_t island) const;

private:
    struct Outgoing {
        std::size_t to;
        Output<Emigrants> output;
        bool idle = true; ///< in asynchronous exchange: the last letter has been sent
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
        Emigrants last;    ///< last emigrants received; empty once accepted
    };

    Emigrants leaving(Search&, std::span<const double> fitness) const;
    void exchange_in_step(const Emigrants&, std::uint64_t generation);
    void exchange_by_mail(const Emigrants&);
    std::vector<Migration> take_arrivals();
    void evaluate_arrivals(std::span<Migration>, std::span<const Sample> window) const;
    void send_letters(Outgoing&);
    void receive_letters(Incoming&);

    std::shared_ptr<const Archipelago> archipelago_; ///< shared with islands that begin later in the run
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
