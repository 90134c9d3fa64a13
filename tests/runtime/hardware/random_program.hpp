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
