#pragma once

#include "runtime/executive.hpp"
#include "runtime/hardware/link_faults.hpp"
#include "runtime/protocol.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

class Link;

/// A command of one to three bytes to the configuration link of a C004, INMOS's link switch. We had no data sheet, and
/// wrote the codes down from memory. INMOS's network checker (check.c of its `ispy`, published) confirms
/// [0][input][output], [4], and the top bit of the answer. It does not send [3].
struct SwitchCommand {
    enum class Kind : std::uint8_t {
        connect_output = 0,    ///< [0][input][output]
        connect_links = 1,     ///< [1][link][link]: connects both directions
        enquire = 2,           ///< [2][output]: asks to which input the output is connected
        ready = 3,             ///< [3]: ends a configuration; from now on the new connections carry data
        reset = 4,             ///< [4]: disconnects all outputs
        disconnect_output = 5, ///< [5][output]
        disconnect_links = 6   ///< [6][link][link]: disconnects both links' outputs
    };
    Kind kind = Kind::ready;
    std::uint8_t first = 0, second = 0;

    std::size_t bytes() const;
    WireForm wire_form() const { return WireForm(bytes()); }
};

/// The byte that answers an enquiry: the number of the input. The top bit is set if the output is connected.
struct SwitchAnswer {
    static constexpr std::uint8_t connected = 0x80;
    std::uint8_t byte = 0;
};

/// An IMS C004: a switch for links, with 32 inputs and 32 outputs. Each output repeats the data of one input, or
/// nothing. Commands change the connections during the run; at the start nothing is connected. Data is lost at an input
/// that no output repeats.
///
/// We assume the following. Data is also lost if the output that repeats it is not wired to the other end of the data's
/// link. On a new connection, data is lost until the next command 3. To make a connection again, or to make other
/// connections, does not disturb a connection.
///
/// The class is an executive, that is, it executes processes. A process on the switch inputs commands from the
/// configuration link and obeys them. This process takes no time beyond the time of the link.
class Crossbar final : public Executive {
public:
    static constexpr int links = 32;
    /// The delay of a bit in the switch, in hundredths of a bit period (C004 manual).
    static constexpr std::int64_t crossing_delay = 175;

    Crossbar(Kernel&, std::string name);

    /// Returns the crossbar that executes the running process. Throws std::logic_error if no crossbar executes it.
    static Crossbar& here();

    /// Obeys the command at once. Returns an answer only for `enquire`. Throws std::invalid_argument for a link that
    /// the switch does not have, and for an unknown kind of command.
    std::optional<SwitchAnswer> obey(const SwitchCommand&);

    /// Returns whether the output repeats the data of the input.
    bool leads(int input, int output) const;

    /// Leads a link through the switch. End a of the link is wired to the switch's link `at_a`, end b to `at_b`.
    /// REQUIRES: the run has not begun.
    void lead_on(Link&, int at_a, int at_b);

    /// Data that came over a link and was lost in the switch, because no output repeated it.
    struct Loss {
        const Link* link;
        bool leaves_a; ///< the data came from end a
        FaultEffect effect;
        int output;        ///< output that should have repeated the first lost packet
        std::string state; ///< state of this output at that time, such as "was connected to no input"
    };
    /// Returns the losses: one Loss for each direction of a link that lost data. The links are in the order of
    /// lead_on(); of a link's directions, the direction from end a comes first.
    std::deque<Loss> losses() const;
    std::uint64_t commands() const { return commands_; }
    /// Returns how many connections were made. A connection of two links counts twice, once for each output.
    std::uint64_t connections() const { return connections_; }

    Time tick(Priority) const override { return std::chrono::microseconds{1}; }
    bool begin_computing(Process&, Cycles, const CodeShape&) override;
    void make_ready(Process&) override;
    void leave(Process&, Process* successor) override;

private:
    /// The input to which an output is connected.
    struct Choice {
        int input = nothing;
        bool ready = false; ///< true once command 3 has come
    };
    static constexpr int nothing = -1;

    /// A link that leads through the switch.
    struct SwitchedLink final : SwitchPath {
        SwitchedLink(Crossbar& c, Link& l, int a, int b)
            : crossbar(c), link(l), at_a(a), at_b(b), from_a{&l, true, {}, 0, ""}, from_b{&l, false, {}, 0, ""} {}
        bool leads_on(bool leaves_a) const override;
        void lose(const FaultEffect::Hit&, bool leaves_a) override;
        int output(bool leaves_a) const { return leaves_a ? at_b : at_a; }
        Crossbar& crossbar;
        Link& link;
        int at_a, at_b;
        Loss from_a, from_b;
    };

    void connect(int input, int output);
    void disconnect(int output);
    void make_all_ready();
    void change(int output, const Choice&);
    SwitchAnswer answer(int output) const;
    std::string state_of(int output) const;
    void trace_change(int output, const Choice& before) const;

    Kernel& kernel_;
    std::array<Choice, links> choices_{}; ///< by output
    std::deque<SwitchedLink> ways_;       ///< a deque, because references must stay valid
    std::uint64_t commands_ = 0, connections_ = 0;
};

} // namespace placedpar::hardware
