#include "monitor/memory/writer.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::monitor {

Writer::Writer(StateFile& file, std::function<void(Progress)> tell)
    : file_(file), tell_(std::move(tell)), thread_([this] { run(); }) {}

Writer::~Writer() {
    {
        std::lock_guard lock(mutex_);
        stop_ = true;
    }
    came_.notify_one();
    thread_.join();
}

std::uint64_t Writer::put(Parcel parcel) {
    std::uint64_t number = 0;
    {
        std::lock_guard lock(mutex_);
        waiting_.parcels.push_back(std::move(parcel));
        number = ++waiting_.last_parcel;
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
    done_.wait(lock, [this] { return !busy_ && waiting_.parcels.empty() && waiting_.looks.empty(); });
    return finished_.trouble;
}

void Writer::run() {
    while (true) {
        Work work = next();
        if (work.parcels.empty() && work.looks.empty())
            return;
        std::string trouble = work.parcels.empty() ? trouble_ : commit(std::move(work.parcels));
        finish({work.last_parcel, trouble});
        for (const auto& look : work.looks)
            look(file_);
        {
            std::lock_guard lock(mutex_);
            busy_ = false;
        }
        done_.notify_all();
    }
}

/// Waits for it; nothing when it is time to stop.
Writer::Work Writer::next() {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [this] { return stop_ || !waiting_.parcels.empty() || !waiting_.looks.empty(); });
    Work work = std::move(waiting_);
    waiting_ = {{}, {}, work.last_parcel};
    busy_ = true;
    return work;
}

/// Gives the trouble.
std::string Writer::commit(std::vector<Parcel> parcels) {
    std::span<const Parcel> left = parcels;
    if (broken_) {
        auto anew = std::ranges::find_if(parcels, [](const Parcel& parcel) { return parcel.all_anew_at.has_value(); });
        left = left.subspan(static_cast<std::size_t>(anew - parcels.begin()));
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

void Writer::finish(Progress progress) {
    {
        std::lock_guard lock(mutex_);
        finished_ = progress;
    }
    tell_(std::move(progress));
}

} // namespace placedpar::monitor
