#include "native/rank_member.hpp"

#include "runtime/packed_form.hpp"
#include "runtime/simulation.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

namespace placedpar {

template <>
struct PackedForm<native::QuietAnswer>
    : PackedMembers<native::QuietAnswer, &native::QuietAnswer::sent, &native::QuietAnswer::received,
                    &native::QuietAnswer::awaits_end> {};

} // namespace placedpar

namespace placedpar::native {

namespace {

using Channel32 = std::uint32_t;
constexpr int note_parcel = 0;
int parcel_of(std::size_t channel) { return static_cast<int>(channel) + 1; }

constexpr std::size_t letter_head = 1 + sizeof(Channel32);

void sleep_after(Time waited, Time at_most) {
    std::this_thread::sleep_for(std::chrono::ceil<std::chrono::nanoseconds>(std::min(pause_after(waited), at_most)));
}

} // namespace

RankMember::RankMember(RankMail& mail, Simulation& simulation, std::size_t channels)
    : mail_(mail), simulation_(simulation), ends_(channels), detection_(static_cast<std::size_t>(mail.count())) {
    simulation.run_among(*this, static_cast<std::uint32_t>(mail.own()));
}

template <class... Parts>
void RankMember::send(int to, Kind kind, const Parts&... parts) {
    letter_.assign(1, static_cast<std::uint8_t>(kind));
    (pack(parts, letter_), ...);
    mail_.send(to, letter_);
}

/// Sends a letter that gives the other rank something to do, and counts it for the detection of the end
/// (QuietDetection).
template <class... Parts>
void RankMember::send_counted(int to, Kind kind, const Parts&... parts) {
    ++sent_;
    send(to, kind, parts...);
}

void RankMember::send_to_others(Kind kind) {
    for (int rank = 0; rank < mail_.count(); ++rank)
        if (rank != mail_.own())
            is_counted(kind) ? send_counted(rank, kind) : send(rank, kind);
}

void RankMember::send_message(int to, std::size_t channel, std::span<const std::uint8_t> packed) {
    if (letter_head + packed.size() > RankMail::longest_letter) {
        send_counted(to, Kind::parcel, static_cast<Channel32>(channel), std::uint64_t{packed.size()});
        return mail_.send_parcel(to, parcel_of(channel), {packed.begin(), packed.end()});
    }
    ++sent_;
    letter_.assign(1, static_cast<std::uint8_t>(Kind::message));
    pack(static_cast<Channel32>(channel), letter_);
    letter_.insert(letter_.end(), packed.begin(), packed.end());
    mail_.send(to, letter_);
}

void RankMember::send_taker(int to, std::size_t channel) {
    send_counted(to, Kind::taker, static_cast<Channel32>(channel));
}

void RankMember::expect_parcel(int from, std::size_t channel, std::size_t bytes) {
    mail_.expect_parcel(from, parcel_of(channel), bytes);
}

void RankMember::send_note(MessageBytes note) {
    send(0, Kind::note, std::uint64_t{note.size()});
    mail_.send_parcel(0, note_parcel, std::move(note));
}

void RankMember::interrupt() {
    interrupted_ = true;
    simulation_.interrupt();
}

void RankMember::stop_others() {
    if (!std::exchange(others_stop_, true))
        send_to_others(Kind::stop);
}

Time RankMember::now() const { return std::chrono::duration_cast<Time>(std::chrono::steady_clock::now() - begun_); }

/// Ends the program, and with it all ranks, because without the damaged letter the run cannot end properly.
[[noreturn]] void RankMember::refuse_damaged(const RankLetter& letter, const NoMessage& what) const {
    fmt::print(stderr, "placedpar: rank {} received a damaged message of {} bytes from rank {}: {}\n", mail_.own(),
               letter.bytes.size(), letter.from, what.what());
    std::abort();
}

/// Handles a letter (a short message between ranks) that concerns no process. Returns false for a letter to a process.
bool RankMember::handle_at_once(const RankLetter& letter) {
    PackedReader from(letter.bytes);
    switch (PackedForm<Kind>::read(from)) {
    case Kind::message:
    case Kind::parcel:
    case Kind::taker: return false;
    case Kind::quiet:
        ++received_;
        is_quiet_ = !is_stopped_;
        return true;
    case Kind::over: is_over_ = true; return true;
    case Kind::question: is_asked_ = true; return true;
    case Kind::answer:
        heed(detection_.take(static_cast<std::size_t>(letter.from), PackedForm<QuietAnswer>::read(from)));
        return true;
    case Kind::stop:
        ++received_;
        others_stop_ = true;
        interrupt();
        return true;
    case Kind::note: mail_.expect_parcel(letter.from, note_parcel, PackedForm<std::uint64_t>::read(from)); return true;
    }
    throw NoMessage("its kind of message does not exist");
}

/// Passes a letter to the end of its channel.
void RankMember::handle_for_process(const RankLetter& letter) {
    PackedReader from(letter.bytes);
    const Kind kind = PackedForm<Kind>::read(from);
    const auto channel = PackedForm<Channel32>::read(from);
    if (channel >= ends_.size() || !ends_[channel])
        throw NoMessage(fmt::format("channel {} does not lead to this rank", channel));
    if (kind == Kind::message)
        ends_[channel]->message_came(from.take(from.left()));
    else if (kind == Kind::taker)
        ends_[channel]->taker_came();
    else
        ends_[channel]->parcel_announced(PackedForm<std::uint64_t>::read(from));
}

/// Receives letters and parcels until one for a process has come, which is stored in `held_` or `held_parcel_`. Returns
/// whether such a letter or parcel is stored.
bool RankMember::fetch() {
    while (!held_) {
        std::optional<RankLetter> letter = mail_.receive();
        if (!letter)
            break;
        try {
            if (!handle_at_once(*letter))
                held_ = letter;
        } catch (const NoMessage& what) {
            refuse_damaged(*letter, what);
        }
    }
    while (!held_parcel_) {
        std::optional<RankParcel> parcel = mail_.receive_parcel();
        if (!parcel)
            break;
        if (parcel->number == note_parcel)
            receiver_(parcel->from, parcel->bytes);
        else
            held_parcel_ = std::move(parcel);
    }
    return held_ || held_parcel_;
}

/// Passes the held letter or parcel to the end of its channel.
void RankMember::handle_held() {
    if (std::optional<RankParcel> parcel = std::exchange(held_parcel_, std::nullopt))
        ends_[static_cast<std::size_t>(parcel->number - parcel_of(0))]->parcel_came(std::move(parcel->bytes));
    const std::optional<RankLetter> letter = std::exchange(held_, std::nullopt);
    if (!letter)
        return;
    ++received_;
    try {
        handle_for_process(*letter);
    } catch (const NoMessage& what) {
        refuse_damaged(*letter, what);
    }
}

void RankMember::take_arrivals() noexcept {
    if (held_ || held_parcel_)
        return handle_held(); // rest() has just looked for messages
    while (fetch())
        handle_held();
}

/// Takes part in the detection of the end: rank 0 asks, the other ranks answer. REQUIRES: this rank has nothing to do.
void RankMember::take_part_in_rounds(bool awaits_end) {
    const QuietAnswer own_answer{sent_, received_, awaits_end};
    if (mail_.own() == 0 && !detection_.is_asking())
        begin_round(own_answer);
    else if (std::exchange(is_asked_, false))
        send(0, Kind::answer, own_answer);
}

void RankMember::begin_round(const QuietAnswer& own_answer) {
    detection_.ask();
    send_to_others(Kind::question);
    heed(detection_.take(0, own_answer));
}

void RankMember::heed(QuietDetection::Verdict verdict) {
    if (verdict == QuietDetection::Verdict::quiet) {
        send_to_others(Kind::quiet);
        is_quiet_ = !is_stopped_;
    } else if (verdict == QuietDetection::Verdict::over) {
        send_to_others(Kind::over);
        is_over_ = true;
    }
}

/// Returns the time for which a rank checks for messages without a pause. It is 0 if this computer has fewer cores than
/// ranks.
Time RankMember::patience() const {
    static const unsigned cores = std::thread::hardware_concurrency(); // called only once, because the call takes
                                                                       // microseconds
    return static_cast<unsigned>(mail_.count_here()) <= cores ? most_patience_of_rank : Time{0};
}

/// Returns the reason why rest() must return, or nullopt if it must continue to wait.
std::optional<Surroundings::Rest> RankMember::look(bool is_due, bool awaits_end, bool may_answer) {
    const bool has_come = fetch();
    if (is_over_)
        return Rest::forever;
    if (std::exchange(is_quiet_, false))
        return Rest::quiet;
    if (has_come || interrupted_ || is_due)
        return Rest::over;
    if (may_answer && mail_.has_all_parcels())
        take_part_in_rounds(awaits_end);
    return std::nullopt;
}

Surroundings::Rest RankMember::rest(Time due, bool awaits_end) {
    const Time since = now(), patient_until = since + patience();
    for (;;) {
        const Time time = now();
        const bool is_patient = time < patient_until;
        if (const std::optional<Rest> end = look(time >= due, awaits_end, !is_patient && due == Time::max())) {
            rested_ += time - since;
            if (end == Rest::quiet && !rested_in_work_)
                rested_in_work_ = rested_;
            return *end;
        }
        if (!is_patient)
            sleep_after(time - since, due - time);
    }
}

void RankMember::wait_for_stop(bool failed) {
    if (failed)
        interrupt();
    is_stopped_ = true;
    for (RankEnd* end : ends_)
        if (end)
            end->end();
    for (const Time since = now(); !is_over_ || !mail_.has_all_parcels(); sleep_after(now() - since, Time::max())) {
        take_arrivals();
        if (interrupted_)
            stop_others();
        if (!is_over_ && mail_.has_all_parcels())
            take_part_in_rounds(false);
    }
}

void RankMember::receive_notes_until(const std::function<bool()>& has_all) {
    for (const Time since = now(); fetch(), !has_all();)
        sleep_after(now() - since, Time::max());
}

std::vector<const Kernel*> RankMember::kernels() const { return {&simulation_.kernel()}; }

} // namespace placedpar::native
