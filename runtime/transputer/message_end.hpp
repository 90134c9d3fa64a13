#pragma once

#include "runtime/byte_form.hpp"
#include "runtime/carrier.hpp"
#include "runtime/executive.hpp"
#include "runtime/source_location.hpp"
#include "runtime/transputer/byte_lane.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace placedpar {
class AnyChannel;
class Process;
} // namespace placedpar

namespace placedpar::transputer {

/// Connects C++ processes with an emulated transputer that executes its own code: the end of a link at which the C++
/// processes output and input messages. One channel can use each direction. Its messages travel as bytes (ByteForm):
/// this end sends or receives all bytes of a message part together, as the instructions `out` and `in` do. A process
/// continues when the last byte has been acknowledged, or has arrived. The transputer may receive or send the bytes in
/// other portions.
///
/// input() throws NoMessage for bytes that are not a message of the channel's protocol.
class MessageEnd final : public ByteEnd, public Carrier {
public:
    /// `partner` is the name of the device at the other end, for reports.
    explicit MessageEnd(std::string partner) : partner_(std::move(partner)) {}
    MessageEnd(const MessageEnd&) = delete;
    MessageEnd& operator=(const MessageEnd&) = delete;

    /// Put a channel on the direction from (to) this end. Throw std::logic_error if the direction has a channel
    /// already, and if messages of the channel have no byte form. REQUIRES: the lanes of this end are set; the run has
    /// not begun; the channel and this end outlive the run.
    void carry_outputs(AnyChannel&);
    void carry_inputs(AnyChannel&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return in->has_byte(); }
    bool output_is_lost(const AnyChannel& c) const override { return out->wire().output_is_lost(c); }
    bool input_is_lost(const AnyChannel& c) const override { return in->wire().input_is_lost(c); }
    bool output_must_be_reset(const AnyChannel& c) const override { return out->wire().output_must_be_reset(c); }
    bool input_must_be_reset(const AnyChannel& c) const override { return in->wire().input_must_be_reset(c); }
    std::string why_not_given_up() const override { return ""; }
    /// Forget the rest of the message, as `resetch` does. If the transputer has begun to move the message, too, its
    /// program must reset its channel before it moves further bytes.
    bool give_up_output(AnyChannel&) override;
    bool give_up_input(AnyChannel&) override;
    std::uint64_t reset_output(AnyChannel&) override { return std::exchange(outputs_.moved_when_given_up, 0); }
    std::uint64_t reset_input(AnyChannel&) override;
    std::string partner_device() const override { return partner_; }

private:
    /// The instruction `out` or `in` for one part of a message.
    struct Transfer final : Communication {
        Transfer(MessageEnd& e, Activity a) : end(e), activity(a) {}
        bool begin(Process&) noexcept override;
        void move(AnyChannel&, std::uint32_t bytes, const SourceLocation&);
        void has_ended();
        void wake();
        void begin_message() {
            given_up = ended = false;
            moved = 0;
        }
        void give_up(std::uint64_t of_part);
        MessageEnd& end;
        Activity activity;
        AnyChannel* channel = nullptr; ///< the channel that uses the direction; null if there is none
        MessageBytes message = {};     ///< the bytes of the current message
        std::uint32_t part = 0;        ///< the length of the current part
        SourceLocation where = {};
        Process* process = nullptr; ///< waits for the end of the part
        bool ended = false;
        bool given_up = false;   ///< the current message was abandoned
        std::uint64_t moved = 0; ///< bytes of the message's completed parts
        std::uint64_t moved_when_given_up = 0;
    };

    bool has_whole_message(const AnyChannel&);
    static void carry(AnyChannel&, Transfer&, MessageEnd&, ByteLane&);

    void read(std::span<std::uint8_t>) override;
    void given() override { outputs_.has_ended(); }
    void write(std::span<const std::uint8_t>) override;
    void taken() override { inputs_.has_ended(); }
    void byte_waits() override;

    std::string partner_;
    std::size_t bytes_read_ = 0; ///< bytes of the outgoing message that have left
    Transfer outputs_{*this, Activity::outputting}, inputs_{*this, Activity::inputting};
};

} // namespace placedpar::transputer
