#pragma once

#include "native/quiet_detection.hpp"
#include "ranks/rank_mail.hpp"
#include "runtime/byte_form.hpp"
#include "runtime/surroundings.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {
class Simulation;
} // namespace placedpar

namespace placedpar::native {

/// The time for which a rank without work checks for messages continuously before it sleeps in pauses. A rank is a copy
/// of the program, started by mpirun.
inline constexpr Time most_patience_of_rank = std::chrono::microseconds(50);

/// The end of a channel that leads to another rank. Its functions are called with what the other end sends: letters,
/// which are short, and parcels, which are long messages that a letter announces.
class RankEnd {
public:
    virtual void message_came(std::span<const std::uint8_t> /*packed*/) {}
    /// Called when a parcel with a message of this length is ready to be sent.
    virtual void parcel_announced(std::size_t /*bytes*/) {}
    virtual void parcel_came(MessageBytes /*packed*/) {}
    /// Called when it is certain that the process at the other end will take the next message.
    virtual void taker_came() {}
    /// Called when the kernel has stopped. An announced parcel is still received, because a parcel cannot be cancelled.
    virtual void end() {}

protected:
    ~RankEnd() = default;
};

/// Connects the kernel of one rank of a native run with the other ranks. Sends and receives messages, sleeps while the
/// kernel has nothing to do, and takes part in ending the run. All functions except interrupt() are called by the
/// thread of the kernel.
class RankMember final : public Surroundings {
public:
    /// `channels`: number of channels of the whole network. REQUIRES: the mail and the simulation outlive this object.
    RankMember(RankMail&, Simulation&, std::size_t channels);

    /// Sets this rank's end of a channel. REQUIRES: the end outlives the run.
    void set_end(std::size_t channel, RankEnd& end) { ends_[channel] = &end; }
    /// Sends a packed message over a channel, in a letter, or in a parcel if it is long.
    void send_message(int to, std::size_t channel, std::span<const std::uint8_t> packed);
    void send_taker(int to, std::size_t channel);
    void expect_parcel(int from, std::size_t channel, std::size_t bytes);

    /// Sends a note to rank 0, that is, a message from a process to the program, outside of channels.
    void send_note(MessageBytes);
    /// Sets the function that receives the notes to this rank. The notes of one rank arrive in the order in which they
    /// were sent.
    void receive_notes(std::function<void(int from, const MessageBytes&)> receiver) { receiver_ = std::move(receiver); }
    /// Receives notes until `has_all` returns true. REQUIRES: the run is over.
    void receive_notes_until(const std::function<bool()>& has_all);

    /// Starts the clock of the run.
    void begin() { begun_ = std::chrono::steady_clock::now(); }
    /// Returns the reading of the computer's clock at the start of the run.
    std::chrono::nanoseconds begun() const { return begun_.time_since_epoch(); }
    /// Ends the run of each rank. May be called by any thread.
    void interrupt();
    /// Returns how long the kernel had nothing to do before the end of the work.
    Time rested() const { return rested_in_work_.value_or(rested_); }
    /// Sets the function that is called when all kernels have stopped, while the processes are still in their waits.
    void before_reports(std::function<void()> action) { before_reports_ = std::move(action); }

    Time now() const override;
    void take_arrivals() noexcept override;
    Rest rest(Time due, bool awaits_end) override;
    void wait_for_stop(bool failed) override;
    std::vector<const Kernel*> kernels() const override;
    void wait_for_reports() override { before_reports_(); }

private:
    enum class Kind : std::uint8_t { message, parcel, taker, quiet, over, question, answer, stop, note };

    static bool is_counted(Kind kind) { return kind == Kind::quiet || kind == Kind::stop; }
    template <class... Parts>
    void send(int to, Kind, const Parts&...);
    template <class... Parts>
    void send_counted(int to, Kind, const Parts&...);
    void send_to_others(Kind);
    bool fetch();
    void handle_held();
    bool handle_at_once(const RankLetter&);
    void handle_for_process(const RankLetter&);
    [[noreturn]] void refuse_damaged(const RankLetter&, const NoMessage&) const;
    void take_part_in_rounds(bool awaits_end);
    void begin_round(const QuietAnswer& own_answer);
    void heed(QuietDetection::Verdict);
    std::optional<Rest> look(bool is_due, bool awaits_end, bool may_answer);
    void stop_others();
    Time patience() const;

    RankMail& mail_;
    Simulation& simulation_;
    std::chrono::steady_clock::time_point begun_;
    std::vector<RankEnd*> ends_; ///< by the number of the channel
    std::function<void(int, const MessageBytes&)> receiver_ = [](int, const MessageBytes&) {};
    std::function<void()> before_reports_ = [] {};
    std::optional<RankLetter> held_; ///< a letter for a process, kept until the next call of take_arrivals()
    std::optional<RankParcel> held_parcel_;
    MessageBytes letter_; ///< memory for the letter that is being written
    std::uint64_t sent_ = 0, received_ = 0;
    QuietDetection detection_; ///< used by rank 0
    bool is_asked_ = false;    ///< this rank has not yet answered a question of rank 0
    bool is_quiet_ = false, is_over_ = false, is_stopped_ = false, others_stop_ = false;
    std::atomic<bool> interrupted_{false};
    Time rested_{};
    std::optional<Time> rested_in_work_; ///< set at the end of the work, if the kernel continues after it
};

} // namespace placedpar::native
