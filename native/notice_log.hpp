#pragma once

#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace placedpar::native {

/// A record of one event: a process changes its activity, or does its part of a communication. Processes, channels and
/// lists of channels are numbers: indices in the tables of Notices.
struct Notice {
    enum class Kind : std::uint8_t {
        turn,
        local_message,   ///< a message within one kernel (one thread or rank); the outputter's notice is followed by
                         ///< the inputter's
        crossing_message ///< a message from or to another kernel, which records the other process's part
    };

    Time at;
    std::uint32_t process;
    std::uint32_t subject = 0; ///< number of the list of awaited channels, or of the message's channel
    std::uint32_t number = 0;  ///< number of the message on its channel, counted at this end
    Kind kind = Kind::turn;
    std::uint8_t activity; ///< an Activity; outputting or inputting for a message
    bool awaits_timer = false;
};

/// What happened on one kernel of a native run (on one thread or rank), in order of time.
struct Notices {
    std::vector<Notice> all;
    std::vector<std::string> processes, channels;    ///< names
    std::vector<std::vector<std::uint32_t>> awaited; ///< lists of channels
    Time over{};                                     ///< when the work was over
    std::optional<Time> full_at;                     ///< time at which the record was full; later notices are missing
};

/// Records what happens on one kernel of a native run. The kernels record separately; NativeTrace joins their notices
/// after the run.
class NoticeLog final : public TraceSink {
public:
    /// Records nothing after `until`, and at most `most` notices. REQUIRES: the kernel belongs to a native run
    /// (Kernel::run_among), and outlives this object.
    NoticeLog(const Kernel& kernel, Time until, std::size_t most) : kernel_(kernel), until_(until), most_(most) {}

    /// REQUIRES: the run is over; called once.
    Notices take() { return std::move(notices_); }

    void turns(const Process&, Activity, Time) override;
    void communicated(const AnyChannel&, Time) override;
    void takes(const PlaceTaken&, Time) override {}
    void leaves(const PlaceLeft&, Time) override {}
    void over(Time) override;

private:
    Time later_than_last(Time);
    Time read_clock();
    void add(Notice);
    void add_part(const AnyChannel&, const Process&, Activity, Notice::Kind);
    bool has(const Process* process) const { return process && &process->kernel() == &kernel_; }
    std::uint32_t number_of(const Process&);
    std::uint32_t number_of_awaited(const Process&);
    std::uint32_t number_of(const AnyChannel&);

    const Kernel& kernel_;
    Time until_;
    std::size_t most_;
    Notices notices_;
    Time last_{};
    std::unordered_map<std::uint32_t, std::uint32_t> living_; ///< number of each living process, by its ordinal
    std::unordered_map<std::string, std::uint32_t> processes_, channels_;
    std::map<std::vector<std::uint32_t>, std::uint32_t> awaited_;
    std::vector<std::array<std::uint32_t, 2>>
        messages_; ///< for each channel, the number of messages that were output and input
};

} // namespace placedpar::native
