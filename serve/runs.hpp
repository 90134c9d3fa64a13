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
    std::size_t at_once = 0;        ///< number of jobs at a time; 0: one for each core
    std::size_t most_waiting = 500; ///< value of our choice
    RunLimits run;
};

/// Does jobs (serve/job.hpp), each in a process of its own. Other jobs wait in a queue, in which checks come before
/// runs: they are short, and the user is typing. All functions are called from the loop's only thread.
class Runs {
public:
    /// Receives the answer, which is JSON.
    using Done = std::function<void(std::string)>;
    using Number = std::uint64_t;

    Runs(boost::asio::io_context& io, const QueueLimits& limits);
    ~Runs();

    /// Begins a job or adds it to the queue. Returns nothing if too many are waiting. `name` is for place_of().
    std::optional<Number> add(std::string name, bool is_check, std::string job, Done done);
    /// Ends a job, and kills its process, without an answer. No effect if the job has been answered.
    void withdraw(Number job);
    /// Returns the number of jobs before the one with this name; 0 if it has begun, nothing if there is no such job.
    std::optional<std::size_t> place_of(const std::string& name) const;
    std::size_t waiting() const { return waiting_.size(); }

private:
    class Process;
    struct Waiting {
        Number number;
        std::string name;
        bool is_check;
        std::string job;
        Done done;
    };

    void begin_next();
    void ended(Process& process, std::string answer);

    boost::asio::io_context& io_;
    QueueLimits limits_;
    Number last_ = 0;
    std::list<Waiting> waiting_;
    std::list<std::shared_ptr<Process>> running_;
};

} // namespace placedpar::serve
