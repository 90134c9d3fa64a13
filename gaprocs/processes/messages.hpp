#pragma once

#include "gaprocs/processes/share.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/protocol.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace placedpar {

/// The greatest length of a message in bytes. The netlist states the length of each message on the wire (thesis,
/// appendix E: 148 bytes of measurements, 240 of strings, 240 of fitness). The size of this program's own data has no
/// influence. A word before the bytes holds the type and the count, as in occam's counted array, whose count is an INT.
inline constexpr std::int64_t largest_message_bytes = 0x7fffffff;

/// Returns the length of a message in bytes. It holds `individuals` strings or fitnesses of `bytes_each` bytes, and
/// `others` further bytes. Throws UserError if the length exceeds largest_message_bytes.
std::uint32_t message_bytes(std::size_t individuals, std::uint32_t bytes_each, std::uint32_t others = 0);

struct SizedMessage {
    std::uint32_t bytes = 0;
    WireForm wire_form() const { return WireForm(4u, bytes); }
};

/// Carries a sample of the record from the host, or marks the end of the record.
struct HostMessage : SizedMessage {
    bool end = false;
    Sample sample;
    Time read_at{}; ///< when sensors read it (ga.sensors)
    bool operator==(const HostMessage& other) const {
        return bytes == other.bytes && end == other.end && sample == other.sample;
    }
};

using Window = std::shared_ptr<const std::vector<Sample>>;

/// Carries strings from a master to a slave, which evaluates them.
struct Task : SizedMessage {
    enum class Kind { evaluate, rehearse, end } kind = Kind::end;
    std::size_t slave = 0;   ///< number of the addressed slave, counted from the master
    std::size_t master = 0;  ///< number of the sending master among the masters of a pipeline
    std::size_t address = 0; ///< 0: the task is for the receiving slave; otherwise for a slave behind it, numbered from
                             ///< 1 as in SlaveRoutes
    Share share;
    std::vector<Genome> strings; ///< all individuals that have evaluations in the share
    Window window;               ///< the measurements; null if the slave has received them before
    double bias = 0;
    Coding coding = Coding::natural; ///< coding of the strings
    bool results_in_order = false; ///< true: in each round return the farthest slave's result first; false: return each
                                   ///< result when it is ready
    std::size_t tasks_under_way = 1; ///< largest number of unanswered tasks of the addressed slave
};

/// Answers a task with the sums of the share's evaluations, one for each individual.
struct Fitnesses : SizedMessage {
    bool end = false;                  ///< true in the answer to Task::Kind::end
    std::size_t slave = 0, master = 0; ///< copied from the task
    std::size_t hops = 0;              ///< number of slaves that have passed the message on
    Share share;
    std::vector<double> terms;
};

/// A message between two processes of one processor. They share its memory, so only the address of the message is
/// passed.
template <class T>
struct InPlace {
    T message;
    WireForm wire_form() const { return WireForm(4u); }
};

/// Carries emigrants from an island to a neighbour.
struct Emigrants : SizedMessage {
    bool end = false; ///< true: the island has ended; only used in asynchronous exchange
    std::uint64_t generation = 0;
    std::vector<Individual> individuals;
};

/// Carries the best individual. A search sends it to its host after the generations of each sample; an island sends it
/// to the analyst at each exchange.
struct EstimateMessage : SizedMessage {
    bool end = false; ///< true: the search has ended
    std::uint64_t generation = 0;
    std::size_t samples = 0; ///< samples that the search has received so far
    Individual best;
};

/// Reports the fittest estimate after a sample, from a host to its alarm.
struct Finding : SizedMessage {
    bool end = false;
    std::size_t sample = 0;         ///< counted from 1
    Time read_at{}, sent_at{};      ///< when the sensors read the sample, and when the host had the finding
    std::vector<double> parameters; ///< decoded
};

/// Carries the bias point from the coarse search to the fine search, which searches around it.
struct BiasPoint : SizedMessage {
    Genome string; ///< a string of the problem, in natural binary
};

} // namespace placedpar
