#pragma once

#include "machine_log.hpp"
#include "random_pace.hpp"
#include "runtime/channel.hpp"
#include "runtime/random.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placedpar::test {

/// A message of up to three parts.
struct Letter {
    int number = 0;
    std::uint32_t head = 0, body = 1, tail = 0;
    WireForm wire_form() const { return WireForm(head, body, tail); }
};

/// A channel of a random machine, and the numbers of its letters: of those that have gone, as their sender knows, and
/// of those that came.
struct Lane {
    Lane(const std::string& name, bool can_be_given_up_)
        : channel(name), output_fails(name + " output fails"), input_fails(name + " input fails"),
          can_be_given_up(can_be_given_up_) {}
    /// In order, none twice; all that have gone, except for one that its receiver may not have come to look at.
    bool is_whole() const;

    Channel<Letter> channel;
    Channel<int> output_fails, input_fails; ///< soft: a message ends an attempt
    bool can_be_given_up, failures_are_told = false;
    std::vector<int> gone, came;
};

/// What a process of a random machine does, for so many rounds.
class RandomProgram {
public:
    RandomProgram(RandomStream, const RandomPace&, int rounds, MachineLog&);

    void send(Lane&);
    /// From each of them. REQUIRES: there is one.
    void receive(const std::vector<Lane*>&);
    /// That, each time after so many bits at most.
    void repeat(std::uint32_t bits, const std::function<void(RandomStream&)>&);

private:
    void send_or_give_up(Lane&, const Letter&);
    void alternate(const std::vector<Lane*>&);
    void receive_from(Lane&, bool may_be_given_up);
    void receive_or_give_up(Lane&);
    Letter letter(int number);
    void pause();
    Time soon();
    Time middle_of(const Letter&);
    void note(const std::string& what, const Lane&, std::uint64_t value);

    RandomStream random_;
    const RandomPace& pace_;
    int rounds_;
    MachineLog& log_;
    // What sort of program it is.
    std::uint32_t longest_letter_; ///< bytes, of its longest part
    std::uint32_t patience_;       ///< bits: at most so long it waits before it gives up
    double pauses_;                ///< how often it rests before it does something
    double gives_up_; ///< how often it is ready to. A channel lasts if both ends are always: else one waits for ever
};

} // namespace placedpar::test
