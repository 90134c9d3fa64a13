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
    std::size_t at_once = 0;                                    ///< number of jobs at a time; 0: one for each core
    std::size_t most_waiting = 500, most_waiting_of_peer = 100; ///< values of our choice
    RunLimits run;
};

/// Executes jobs (serve/answer.hpp), each in its own process. Further jobs wait in a queue. Checks come before runs in
/// the queue, because checks are short and the user is typing. All functions are called from the loop's only thread.
class Runs {
public:
    /// Receives the answer, which is JSON.
    using Done = std::function<void(std::string)>;
    using Number = std::uint64_t;
    /// Returns the job's text. It is called when the job begins, so that waiting jobs need little memory.
    using Text = std::function<std::string()>;

    Runs(boost::asio::io_context& io, const QueueLimits& limits);
    ~Runs();

    /// Begins a job or adds it to the queue. Returns nothing if too many jobs are waiting, in total or from this peer
    /// (web::Caller). `name` is for place_of().
    std::optional<Number> add(std::string name, std::string peer, bool is_check, Text job, Done done);
    /// Ends a job without an answer, and kills its process. Has no effect if the job has been answered.
    void withdraw(Number job);
    /// Returns the job's place in the queue, from 1; 0 if it has begun; nothing if there is no such job.
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
