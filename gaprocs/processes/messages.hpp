#pragma once

#include "gaprocs/processes/share.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/byte_form.hpp"
#include "runtime/packed_form.hpp"
#include "runtime/protocol.hpp"
#include "runtime/time.hpp"
#include "text/user_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The greatest length of a message in bytes. The netlist states how many bytes a message takes on a link, so the size
/// of the C++ data does not matter (thesis, appendix E: 148 bytes of measurements, 240 of strings, 240 of fitness). One
/// word before these bytes holds the type and the length of the message. The length must be a positive INT, as in
/// occam's counted arrays.
inline constexpr std::int64_t largest_message_bytes = 0x7fffffff;

/// Returns the length in bytes of a message. It has a string or a fitness value of `bytes_each` bytes for each of
/// `individuals` individuals, and `others` further bytes. Throws UserError if the length exceeds largest_message_bytes.
std::uint32_t message_bytes(std::size_t individuals, std::uint32_t bytes_each, std::uint32_t others = 0);

struct SizedMessage {
    std::uint32_t bytes = 0;
    WireForm wire_form() const { return WireForm(4u, bytes); }
};

/// Between the ranks of a run on several computers, a string is sent as its length in bits, followed by its words.
template <>
struct PackedForm<Genome> {
    static void write(const Genome& genome, MessageBytes& to) {
        pack(std::uint64_t{genome.size()}, to);
        for (const std::uint64_t word : genome.words())
            pack(word, to);
    }
    static Genome read(PackedReader& from) {
        const auto bits = PackedForm<std::uint64_t>::read(from);
        if (bits / 8 > from.left())
            throw NoMessage("a string of " + std::to_string(bits) + " bits");
        Genome genome(bits);
        for (std::size_t i = 0; i < bits / 64; ++i)
            genome.set_word(i, PackedForm<std::uint64_t>::read(from));
        if (const std::size_t rest = bits % 64)
            genome.set_field(bits - rest, rest, PackedForm<std::uint64_t>::read(from) >> (64 - rest));
        return genome;
    }
};

template <>
struct PackedForm<Coding> {
    static void write(const Coding& coding, MessageBytes& to) { pack(coding.text(), to); }
    static Coding read(PackedReader& from) {
        const std::string text = PackedForm<std::string>::read(from);
        try {
            return Coding::named(text);
        } catch (const UserError&) {
            throw NoMessage("a coding \"" + text + "\"");
        }
    }
};

template <>
struct PackedForm<Individual> : PackedMembers<Individual, &Individual::genome, &Individual::fitness> {};

/// Carries a sample of the measurements from the host to a search, or marks the end of the measurements.
struct HostMessage : SizedMessage {
    bool end = false;
    Sample sample;
    Time read_at{}; ///< time at which the sensors read the sample, if there is a ga.sensors
    bool operator==(const HostMessage& other) const {
        return bytes == other.bytes && end == other.end && sample == other.sample;
    }
};

template <>
struct PackedForm<HostMessage>
    : PackedMembers<HostMessage, &HostMessage::bytes, &HostMessage::end, &HostMessage::sample, &HostMessage::read_at> {
};

/// For programs in transputer code, a sample is a message of the occam type `INT::[]REAL64`: the values of the sample,
/// then zeros up to the length of the message. An array of NaN marks the end of the measurements. REQUIRES: the length
/// is a multiple of 8, and the values fit.
template <>
struct ByteForm<HostMessage> {
    using SameAs = std::vector<double>;

    static void write(const HostMessage& message, MessageBytes& to) {
        std::vector<double> values = message.sample;
        values.resize(message.bytes / sizeof(double));
        if (message.end)
            std::ranges::fill(values, std::numeric_limits<double>::quiet_NaN());
        ByteForm<SameAs>::write(values, to);
    }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) { return ByteForm<SameAs>::next_part(so_far); }
    static HostMessage read(std::span<const std::uint8_t> bytes) {
        HostMessage message;
        message.sample = ByteForm<SameAs>::read(bytes);
        message.bytes = static_cast<std::uint32_t>(message.sample.size() * sizeof(double));
        message.end = std::ranges::any_of(message.sample, [](double each) { return std::isnan(each); });
        return message;
    }
};

using Window = std::shared_ptr<const std::vector<Sample>>;

/// Carries strings from a master to a slave, which evaluates them.
struct Task : SizedMessage {
    enum class Kind { evaluate, rehearse, end } kind = Kind::end;
    std::size_t slave = 0;  ///< number of the addressed slave among the master's slaves
    std::size_t master = 0; ///< number of the master among the masters of a ga.pipeline, a process that passes tasks of
                            ///< several masters to the same slaves; 0 without a ga.pipeline
    std::size_t address = 0; ///< 0: the task is for the receiving slave; n > 0: for slave n - 1 behind the receiving
                             ///< slave, as numbered by SlaveRoutes
    Share share;
    std::vector<Genome> strings; ///< all individuals of which the share has an evaluation
    Window window;               ///< the measurements; null if the slave already has them
    double bias = 0;
    Coding coding = Coding::natural; ///< coding of the strings
    bool results_in_order = false;   ///< true: the slave passes on the results of the slaves behind it, then sends its
                                     ///< own result; false: it sends each result when the result is ready
    std::size_t tasks_under_way = 1; ///< largest number of unanswered tasks that the addressed slave may have
};

template <>
struct PackedForm<Task> : PackedMembers<Task, &Task::bytes, &Task::kind, &Task::slave, &Task::master, &Task::address,
                                        &Task::share, &Task::strings, &Task::window, &Task::bias, &Task::coding,
                                        &Task::results_in_order, &Task::tasks_under_way> {};

/// Answers a task: carries the result of evaluate_share() from a slave to its master.
struct Fitnesses : SizedMessage {
    bool end = false;                  ///< true in the answer to Task::Kind::end
    std::size_t slave = 0, master = 0; ///< copied from the task
    std::size_t hops = 0;              ///< number of slaves that have passed the message on
    Share share;
    std::vector<double> terms;
};

template <>
struct PackedForm<Fitnesses>
    : PackedMembers<Fitnesses, &Fitnesses::bytes, &Fitnesses::end, &Fitnesses::slave, &Fitnesses::master,
                    &Fitnesses::hops, &Fitnesses::share, &Fitnesses::terms> {};

/// A message between two processes on one processor. Because they share the processor's memory, only the address of the
/// message is sent.
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

template <>
struct PackedForm<Emigrants>
    : PackedMembers<Emigrants, &Emigrants::bytes, &Emigrants::end, &Emigrants::generation, &Emigrants::individuals> {};

/// Carries the best individual of a search. A search sends it to the host after the last generation of each sample; an
/// island sends it to the analyst at each exchange.
struct EstimateMessage : SizedMessage {
    bool end = false; ///< true: the search has ended
    std::uint64_t generation = 0;
    std::size_t samples = 0; ///< number of samples that the search has received so far
    Individual best;
};

template <>
struct PackedForm<EstimateMessage>
    : PackedMembers<EstimateMessage, &EstimateMessage::bytes, &EstimateMessage::end, &EstimateMessage::generation,
                    &EstimateMessage::samples, &EstimateMessage::best> {};

/// Carries the fittest estimate after a sample, from the host to the alarm.
struct Finding : SizedMessage {
    bool end = false;
    std::size_t sample = 0;         ///< number of the sample, from 1
    Time read_at{}, sent_at{};      ///< time at which the sensors read the sample, and time at which the host sent the
                                    ///< finding
    std::vector<double> parameters; ///< decoded parameters of the estimate
};

template <>
struct PackedForm<Finding> : PackedMembers<Finding, &Finding::bytes, &Finding::end, &Finding::sample, &Finding::read_at,
                                           &Finding::sent_at, &Finding::parameters> {};

/// Carries the bias point, the best string of a coarse search, to the fine search, which searches around this point.
struct BiasPoint : SizedMessage {
    Genome string; ///< a string that the problem reads, in natural binary
};

template <>
struct PackedForm<BiasPoint> : PackedMembers<BiasPoint, &BiasPoint::bytes, &BiasPoint::string> {};

} // namespace placedpar
