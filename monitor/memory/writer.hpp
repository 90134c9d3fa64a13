#pragma once

#include "monitor/memory/state_file.hpp"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace placedpar::monitor {

/// How far the writer has come.
struct WriteProgress {
    std::uint64_t transactions = 0; ///< so many, from the first, have been committed or were lost
    std::string trouble;            ///< why some were lost; "": none were
};

/// Writes parcels to a state file in a thread of its own: all that have come while one transaction went to the disk go
/// into the next.
///
/// 1. Units are committed in the order of put().
/// 2. When a transaction fails, its parcels are lost, and so are all that follow, until one that begins all anew.
/// 3. put(), look() and wait() are called from one thread, which is not the writer's.
class Writer {
public:
    /// `tell` is called in the writer's thread, after each transaction.
    Writer(StateFile& file, std::function<void(WriteProgress)> tell);
    /// Writes what was put.
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Gives its number, from 1.
    std::uint64_t put(Transaction transaction);
    /// Has the history looked into, in the writer's thread, after what was put before.
    void look(std::function<void(StateFile&)> look);
    /// Until all that was put has been committed or lost; gives the trouble with the last of it.
    std::string wait();

private:
    struct Work {
        std::vector<Transaction> transactions;
        std::vector<std::function<void(StateFile&)>> looks;
        std::uint64_t last_transaction = 0;
    };

    void run();
    Work next();
    std::string commit(std::vector<Transaction> transactions);
    void finish(WriteProgress progress);

    StateFile& file_;
    std::function<void(WriteProgress)> tell_;
    std::mutex mutex_;
    std::condition_variable came_, done_;
    Work waiting_; ///< guarded by mutex_, as are those below
    WriteProgress finished_;
    bool busy_ = false, stop_ = false;
    bool broken_ = false; ///< the writer's own: parcels are lost
    std::string trouble_; ///< why
    std::thread thread_;
};

} // namespace placedpar::monitor
