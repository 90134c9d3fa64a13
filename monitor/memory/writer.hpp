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

/// States how far the writer has come.
struct WriteProgress {
    std::uint64_t transactions = 0; ///< number of transactions committed or lost so far
    std::string trouble;            ///< why some transactions were lost; "" if none were lost
};

/// Writes transactions to a state file in a thread of its own, so that the service need not wait for the disk.
/// Transactions that arrive during a commit are committed together in the next commit.
///
/// 1. Transactions are committed in the order of put().
/// 2. When a commit fails, its transactions are lost. Later transactions are lost, too, until a transaction with
///    `all_anew_at` replaces the whole content of the file.
/// 3. put(), look() and wait() are called from one thread other than the writer's.
class Writer {
public:
    /// The writer's thread calls `tell` after each commit.
    Writer(StateFile& file, std::function<void(WriteProgress)> tell);
    /// Writes all transactions that were put, then returns.
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Queues a transaction and returns its number, counted from 1.
    std::uint64_t put(Transaction transaction);
    /// Calls `look` in the writer's thread, after all transactions that were put before are written.
    void look(std::function<void(StateFile&)> look);
    /// Waits until all transactions put so far are committed or lost. Returns the error of the last commit, or "".
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
    Work waiting_; ///< guarded by mutex_, as are the members down to stop_
    WriteProgress finished_;
    bool busy_ = false, stop_ = false;
    bool broken_ = false; ///< used by the writer's thread only: transactions are being lost
    std::string trouble_; ///< the reason for broken_
    std::thread thread_;
};

} // namespace placedpar::monitor
