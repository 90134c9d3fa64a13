#pragma once

#include "native/group.hpp"
#include "native/run_parts.hpp"
#include "runtime/carrier.hpp"
#include "runtime/channel.hpp"

#include <atomic>
#include <cstdint>

namespace placedpar::native {

/// Connects a process with a process on another thread of a native run. Each thread has a kernel, and each kernel has
/// its own object for the channel, a half; the crossing joins the two halves.
///
/// 1. The outputter offers its message, which stays in its memory, and waits.
/// 2. The inputter's kernel takes an offered message when its process inputs, and notifies the outputter's kernel. If
///    an ALT chooses another guard, the offer remains.
///
/// So the communication is synchronous, and the message is moved once without a copy.
class Crossing {
public:
    /// Makes the two channels halves of one channel. REQUIRES: the channels have the same protocol and are unused; all
    /// objects outlive the run.
    Crossing(AnyChannel& outputters, Member& from, AnyChannel& inputters, Member& to)
        : output_(outputters), input_(inputters), from_(from), to_(to) {
        output_.put_on(giver_);
        input_.put_on(taker_);
    }
    Crossing(const Crossing&) = delete;
    Crossing& operator=(const Crossing&) = delete;

    AnyChannel& outputters_half() const { return output_; }
    AnyChannel& inputters_half() const { return input_; }
    /// Returns the messages that the inputter has taken. REQUIRES: the outputter's kernel has stopped.
    const Traffic& sent() const { return sent_; }

private:
    enum class Offer { none, made, taken };

    bool claim();
    void take();

    struct Giver final : Carrier {
        explicit Giver(Crossing& crossing) : c(crossing) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel&, const SourceLocation&) override {}
        bool message_waits(const AnyChannel&) const override { return false; }
        std::string why_not_given_up() const override { return ""; }
        bool give_up_output(AnyChannel&) override;
        Crossing& c;
    };
    struct Taker final : Carrier {
        explicit Taker(Crossing& crossing) : c(crossing) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override {}
        void input(AnyChannel&, const SourceLocation&) override;
        bool message_waits(const AnyChannel&) const override;
        bool keep_message(const AnyChannel&) override;
        std::string why_not_given_up() const override { return ""; }
        bool give_up_input(AnyChannel&) override;
        Crossing& c;
    };
    /// Notifies the inputter's kernel that there may be an offer.
    struct Offered final : Arrival {
        explicit Offered(Crossing& crossing) : c(crossing) {}
        void arrive() noexcept override;
        Crossing& c;
    };
    /// Notifies the outputter's kernel that its message has been taken.
    struct Taken final : Arrival {
        explicit Taken(Crossing& crossing) : c(crossing) {}
        void arrive() noexcept override;
        Crossing& c;
    };

    AnyChannel &output_, &input_;
    Member &from_, &to_;
    Giver giver_{*this};
    Taker taker_{*this};
    Offered offered_{*this};
    Taken taken_{*this};
    std::atomic<Offer> offer_{Offer::none};
    std::atomic<bool> is_posted_{false}; ///< `offered_` is in the inbox
    bool is_kept_ = false;               ///< an ALT has claimed the message; used by the inputter's kernel
    Process* outputter_ = nullptr;       ///< the waiting process; used by the outputter's kernel
    std::uint64_t offered_bytes_ = 0;    ///< size of the offered message; used by the outputter's kernel
    Traffic sent_;                       ///< used by the outputter's kernel
    Process* inputter_ = nullptr;        ///< the waiting process; used by the inputter's kernel
};

} // namespace placedpar::native
