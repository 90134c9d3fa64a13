#pragma once

#include "native/rank_member.hpp"
#include "native/run_parts.hpp"
#include "runtime/carrier.hpp"
#include "runtime/channel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace placedpar::native {

/// The outputter's end of a channel between two ranks of a native run. A rank is a copy of the program, started by
/// mpirun. The inputter's end is a RankTaker.
///
/// 1. The outputter sends its message, and waits.
/// 2. The inputter's end sends a reply as soon as it is certain that the inputter will take the next message. The reply
/// is sent before the message arrives if the inputter is already inputting, and otherwise afterwards. So a message that
/// an ALT does not choose remains available.
/// 3. The outputter continues when it has the reply, the inputter when it has the message.
///
/// So the communication is synchronous, and needs one letter from each end. (A letter is a short message of RankMail.)
/// A longer message is announced in a letter, and sent as a parcel when it is input.
class RankGiver final : public Carrier, public RankEnd {
public:
    /// Makes the channel lead to rank `to`. REQUIRES: the channel is unused and has a packed form; all objects outlive
    /// the run.
    RankGiver(RankMember& member, AnyChannel& channel, std::size_t number, int to)
        : member_(member), channel_(channel), number_(number), to_(to) {
        channel.put_on(*this);
        member.set_end(number, *this);
    }
    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override {}
    bool message_waits(const AnyChannel&) const override { return false; }
    /// Throws UserError: a message to another rank cannot be given up. The text asks the user to place both processes
    /// on one rank.
    std::string why_not_given_up() const override;
    void taker_came() override;

    int to() const { return to_; }
    /// Returns the messages that the inputter has taken.
    const Traffic& sent() const { return sent_; }

private:
    RankMember& member_;
    AnyChannel& channel_;
    std::size_t number_;
    int to_;
    bool is_awaited_ = false; ///< the reply has come, but no message has been output since
    Process* outputter_ = nullptr;
    MessageBytes packed_;
    std::uint64_t bytes_ = 0; ///< bytes that a link would carry for the current message
    Traffic sent_;
};

/// The inputter's end of a channel between two ranks: see RankGiver.
class RankTaker final : public Carrier, public RankEnd {
public:
    /// Makes the channel lead from rank `from`. REQUIRES: as for RankGiver.
    RankTaker(RankMember& member, AnyChannel& channel, std::size_t number, int from)
        : member_(member), channel_(channel), number_(number), from_(from) {
        channel.put_on(*this);
        member.set_end(number, *this);
    }
    void output(AnyChannel&, const WireForm&, const SourceLocation&) override {}
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return count_ > 0; }
    std::string why_not_given_up() const override { return ""; }
    bool give_up_input(AnyChannel&) override;
    void message_came(std::span<const std::uint8_t>) override;
    void parcel_announced(std::size_t bytes) override;
    void parcel_came(MessageBytes) override;
    void end() override;

private:
    /// A message that has not been taken.
    struct Offer {
        enum class State { announced, expected, come }; ///< a message in a letter is `come` from the start
        State state = State::come;
        MessageBytes packed;   ///< the message, if it has arrived
        std::size_t bytes = 0; ///< length of a parcel
    };
    enum class State {
        open,     ///< the first message may remain untaken
        promised, ///< the reply was sent: the first message will be taken
        over      ///< the kernel has stopped
    };

    void promise();
    void add(Offer::State, std::span<const std::uint8_t> packed, std::size_t bytes);
    void ask(Offer&);
    void wake();
    Offer& first() { return offers_[first_]; }

    RankMember& member_;
    AnyChannel& channel_;
    std::size_t number_;
    int from_;
    std::array<Offer, 2>
        offers_; ///< two, because the outputter continues when it has the reply, and may send a second message early
    std::size_t first_ = 0, count_ = 0;
    State state_ = State::open;
    Process* inputter_ = nullptr; ///< the waiting process
};

} // namespace placedpar::native
