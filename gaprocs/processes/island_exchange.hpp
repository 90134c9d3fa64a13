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

/// Exchanges individuals between an island process and its neighbours over channels. (The class Islands in
/// gaprocs/islands.hpp does the same without a simulated machine.)
///
/// If islands exchange in step, the island sends and receives on all channels of an exchange in parallel (P. Welch's
/// I/O-PAR), and waits until all of them have finished. All islands make their exchanges in the same order, so no
/// topology can deadlock. The topology and the schedule determine the channels of an exchange, so the processes at both
/// ends of a channel know when the channel is used.
///
/// In asynchronous exchange, each outgoing channel has a sending process and each incoming channel a receiving process.
/// These processes run at high priority, in parallel with the search. At an exchange, the search gives its emigrants to
/// each idle sending process, and takes the latest emigrants from each receiving process. Receiving processes are
/// always ready, so no sending process waits for long. An island that ends sends an end message to its neighbours.
class IslandExchange {
public:
    /// REQUIRES: the process is a ga.island, and its network has passed check_islands().
    IslandExchange(const ProcessEnvironment&, const SearchProblem&, const SearchSettings&, const Workload&);

    /// Returns the number of samples needed before the first generation, as computed by samples_awaited(); 0 if the
    /// problem has an objective.
    std::size_t samples_to_begin() const { return samples_to_begin_; }
    /// Returns whether this island has an exchange after the evaluation of the generation.
    bool is_due(std::uint64_t generation) const { return has_neighbours_ && schedule_.is_due(generation); }
    /// Returns whether the island sends its best individual to an analyst, which chooses among the islands' answers,
    /// after the generation. An island without neighbours also sends its best individual.
    bool reports_after(std::uint64_t generation) const { return schedule_.is_due(generation); }
    /// Runs `search`. In asynchronous exchange, the sending and receiving processes run in parallel with `search`.
    void beside_mail(const std::function<void()>& search);
    /// Sends the emigrants, and returns the immigrants in the order in which the island must accept them. If necessary,
    /// evaluates immigrants in this island's window; this takes simulated computing time. REQUIRES:
    /// is_due(search.generation() + 1).
    std::vector<Migration> exchange(Search&, std::span<const double> fitness, std::span<const Sample> window);
    const Acceptance& acceptance() const { return acceptance_; }
    /// Returns the process name of another island. REQUIRES: this island receives immigrants from that island.
    const std::string& name_of(std::size_t island) const;

private:
    struct Outgoing {
        std::size_t to;
        Output<Emigrants> output;
        bool idle = true; ///< in asynchronous exchange: the sending process has nothing to send
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
        Emigrants last;    ///< latest emigrants received; empty after exchange() has taken them
    };

    Emigrants leaving(Search&, std::span<const double> fitness) const;
    void exchange_in_step(const Emigrants&, std::uint64_t generation);
    void exchange_by_mail(const Emigrants&);
    std::vector<Migration> take_arrivals();
    void evaluate_arrivals(std::span<Migration>, std::span<const Sample> window) const;
    void send_letters(Outgoing&);
    void receive_letters(Incoming&);

    /// Kept, so that islands that begin later can share the archipelago.
    std::shared_ptr<const Archipelago> archipelago_;
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
