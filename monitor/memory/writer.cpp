#include "monitor/memory/writer.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::monitor {

Writer::Writer(StateFile& file, std::function<void(WriteProgress)> tell)
    : file_(file), tell_(std::move(tell)), thread_([this] { run(); }) {}

Writer::~Writer() {
    {
        std::lock_guard lock(mutex_);
        stop_ = true;
    }
    came_.notify_one();
    thread_.join();
}

std::uint64_t Writer::put(Transaction transaction) {
    std::uint64_t number = 0;
    {
        std::lock_guard lock(mutex_);
        waiting_.transactions.push_back(std::move(transaction));
        number = ++waiting_.last_transaction;
    }
    came_.notify_one();
    return number;
}

void Writer::look(std::function<void(StateFile&)> look) {
    {
        std::lock_guard lock(mutex_);
        waiting_.looks.push_back(std::move(look));
    }
    came_.notify_one();
}

std::string Writer::wait() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return !busy_ && waiting_.transactions.empty() && waiting_.looks.empty(); });
    return finished_.trouble;
}

void Writer::run() {
    while (true) {
        Work work = next();
        if (work.transactions.empty() && work.looks.empty())
            return;
        std::string trouble = work.transactions.empty() ? trouble_ : commit(std::move(work.transactions));
        finish({work.last_transaction, trouble});
        for (const auto& look : work.looks)
            look(file_);
        {
            std::lock_guard lock(mutex_);
            busy_ = false;
        }
        done_.notify_all();
    }
}

/// Waits for work. Returns no work when it is time to stop.
Writer::Work Writer::next() {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [this] { return stop_ || !waiting_.transactions.empty() || !waiting_.looks.empty(); });
    Work work = std::move(waiting_);
    waiting_ = {{}, {}, work.last_transaction};
    busy_ = true;
    return work;
}

/// Commits the transactions. Returns the error, or "" if there was none.
std::string Writer::commit(std::vector<Transaction> transactions) {
    std::span<const Transaction> left = transactions;
    if (broken_) {
        auto anew = std::ranges::find_if(
            transactions, [](const Transaction& transaction) { return transaction.all_anew_at.has_value(); });
        left = left.subspan(static_cast<std::size_t>(anew - transactions.begin()));
    }
    if (left.empty())
        return trouble_;
    try {
        file_.commit(left);
        broken_ = false;
        trouble_.clear();
    } catch (const std::exception& error) {
        broken_ = true;
        trouble_ = error.what();
    }
    return trouble_;
}

void Writer::finish(WriteProgress progress) {
    {
        std::lock_guard lock(mutex_);
        finished_ = progress;
    }
    tell_(std::move(progress));
}

} // namespace placedpar::monitor
