#pragma once

#include "serve/confinement.hpp"

#include <boost/asio/io_context.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

namespace placedpar::serve {

struct QueueLimits {
    std::size_t at_once = 0; ///< number of jobs that run at the same time; 0: one for each core
    std::size_t most_waiting = 500,
                most_waiting_of_peer =
                    100; ///< the greatest number of waiting jobs, of all peers and of one peer; this project's choice
    RunLimits run;
};

/// Executes the jobs of the web page's users (serve/answer.hpp), each in its own process. If all processes are busy, a
/// job waits in a queue. A check of a program's text goes before runs in the queue, because a check is short and its
/// user is typing. All functions are called from the event loop's only thread.
class Runs {
public:
    /// Receives the answer, which is JSON.
    using Done = std::function<void(std::string)>;
    using Number = std::uint64_t;
    /// Returns the job's text. This function is called only when the job begins, so that waiting jobs need little
    /// memory.
    using Text = std::function<std::string()>;

    Runs(boost::asio::io_context& io, const QueueLimits& limits);
    ~Runs();

    /// Begins a job or adds it to the queue. Returns nullopt if too many jobs are waiting, in total or from this peer,
    /// the network address from which they come (web::Caller). place_of() finds the job by `name`.
    std::optional<Number> add(std::string name, std::string peer, bool is_check, Text job, Done done);
    /// Ends a job without an answer, and kills its process. Has no effect if the job has been answered.
    void withdraw(Number job);
    /// Returns the job's place in the queue, counted from 1; 0 if the job has begun; nullopt if no job has this name.
    std::optional<std::size_t> place_of(const std::string& name) const;

private:
    class Process;
    struct Waiting {
        Number number;
        std::string name, peer;
        bool is_check;
        Text job;
        Done done;
    };

    bool has_room_for(const std::string& peer) const;
    void begin_next();
    void ended(Process& process, std::string answer);

    boost::asio::io_context& io_;
    QueueLimits limits_;
    Number last_ = 0;
    std::list<Waiting> waiting_;
    std::list<std::shared_ptr<Process>> running_;
};

} // namespace placedpar::serve
