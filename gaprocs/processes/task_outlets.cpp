#include "gaprocs/processes/task_outlets.hpp"

#include "runtime/kernel.hpp"
#include "runtime/parallel.hpp"

#include <fmt/format.h>

#include <list>
#include <utility>

namespace placedpar {

void TaskOutlets::during(const std::function<void()>& body, const SourceLocation& where) {
    if (sending_ == Sending::in_turn)
        return body();
    std::list<Channel<Handed>> handed;
    handed_.clear();
    for (std::size_t i = 0; i < count(); ++i)
        handed_.push_back(
            &handed.emplace_back(fmt::format("task of {} to send, {}", Kernel::current()->running().path(), i)));
    auto send_by_all = [this] { par_for(count(), [this](std::size_t channel) { send_all_handed(channel); }); };
    auto hand_over = [&] {
        body();
        for (Channel<Handed>* each : handed_)
            each->out().output({});
    };
    run_in_parallel({{send_by_all, Priority::high}, {hand_over, own_priority()}}, where);
}

void TaskOutlets::send(std::size_t channel, Task task) {
    if (sending_ == Sending::in_turn)
        channels_[channel].output(std::move(task));
    else
        handed_[channel]->out().output({std::move(task)});
}

void TaskOutlets::send_all_handed(std::size_t channel) {
    for (auto task = handed_[channel]->in().input().message; task; task = handed_[channel]->in().input().message)
        channels_[channel].output(std::move(*task));
}

} // namespace placedpar
