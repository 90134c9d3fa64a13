#pragma once

#include "identification/compliance_search.hpp"
#include "monitor/protocol/answers.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/thread_pool.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::monitor {

/// Records the movements of all machines. When a movement has ended, a separate thread lets simulated transputers
/// search its compliances. Their network is described by a netlist (option --on).
class NetlistSearches {
public:
    /// Finds the compliances from all samples of a movement. The samples are `period_s` apart. If it finds no answer,
    /// throws a std::exception with the reason.
    using Search = std::function<identification::AnswerInTime(identification::ComplianceSearch, double period_s)>;

    /// The number of movements that may wait for the search. Further movements are skipped. The number is this
    /// project's choice.
    static constexpr std::size_t most_waiting = 16;

    /// `tell` receives each answer. REQUIRES: the thread of `io` calls all functions.
    NetlistSearches(Search search, std::size_t bits, boost::asio::io_context& io,
                    std::function<void(const NetlistAnswer&)> tell)
        : search_(std::move(search)), bits_(bits), io_(io), tell_(std::move(tell)) {}

    /// Records what is new about the movements of the machine. Call this function after each message that the diagnosis
    /// has accepted.
    void follow(const identification::Diagnosis& diagnosis);
    void forget(const std::string& machine) { machines_.erase(machine); }
    /// Returns the newest answer about each set of the machine's links.
    std::vector<NetlistAnswer> answers(const std::string& machine) const;

private:
    /// The present movement of a set of links, and the newest answer.
    struct Recording {
        hydraulics::Circuit circuit;
        std::vector<hydraulics::CircuitSample> samples; ///< samples of the movement, and of up to a second before it
        bool moves = false;
        std::optional<NetlistAnswer> answer = {};
    };
    using Recordings = std::map<hydraulics::LinkSet, std::shared_ptr<Recording>>;

    static void record(const identification::Diagnosis& diagnosis, hydraulics::LinkSet set, Recording& recording);
    void search(const identification::Diagnosis& diagnosis, hydraulics::LinkSet set,
                const std::shared_ptr<Recording>& recording);

    Search search_;
    std::size_t bits_;
    boost::asio::io_context& io_;
    std::function<void(const NetlistAnswer&)> tell_;
    std::map<std::string, Recordings> machines_;
    std::size_t waiting_ = 0;
    boost::asio::thread_pool thread_{1}; ///< its destructor waits for the search under way
};

} // namespace placedpar::monitor
