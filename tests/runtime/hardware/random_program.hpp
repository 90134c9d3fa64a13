#pragma once

#include "machine_log.hpp"
#include "random_lane.hpp"
#include "random_pace.hpp"
#include "runtime/random.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placedpar::test {

/// The behaviour of a process of a random machine, for a number of rounds.
class RandomProgram {
public:
    RandomProgram(RandomStream, const RandomPace&, int rounds, MachineLog&);

    void send(Lane&);
    /// Receives from all given lanes. REQUIRES: there is at least one lane.
    void receive(const std::vector<Lane*>&);
    /// Repeats the action, each time after a wait of at most `bits` bits.
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
    // These members are the program's random character.
    std::uint32_t longest_letter_; ///< length of the longest part, in bytes
    std::uint32_t patience_;       ///< longest wait before it gives up, in bits
    double pauses_;                ///< probability of a rest before an action
    double gives_up_; ///< probability of giving up; a channel keeps working only if both ends may always give up,
                      ///< otherwise one end waits for ever
};

} // namespace placedpar::test
