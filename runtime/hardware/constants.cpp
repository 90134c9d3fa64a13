#include "runtime/hardware/constants.hpp"

#include "runtime/hardware/bus_memory.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/hardware/workstation.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

namespace {

constexpr double in_cycles(Cycles cycles) { return static_cast<double>(cycles); }
constexpr double in_ns(Time time) { return static_cast<double>(time.count()) * 1e-3; }
constexpr double in_us(Time time) { return in_ns(time) * 1e-3; }
constexpr double in_mega(std::int64_t hertz) { return static_cast<double>(hertz) * 1e-6; }

constexpr std::string_view table = "T4 notebook (pahihu/t4), instruction table";
constexpr std::string_view databook_links = "databook (3rd ed., 1992), 1.4";
constexpr std::string_view databook_scheduler = "databook (3rd ed., 1992), 1.3";

std::vector<Constant> of_links() {
    constexpr std::string_view group = "links";
    constexpr std::string_view rates = "measured data rates; published: 5 to 6 bit times (D. Jeffery, 1989)";
    using enum Provenance;
    return {
        {group, "speed, if the netlist states none", in_mega(LinkTiming::usual_speed), "Mbit/s", published,
         "databook (3rd ed., 1992), 1.4: 5, 10 and 20 Mbit/s"},
        {group, "a byte", LinkTiming::data_bits, "bits", published, databook_links},
        {group, "an acknowledge", LinkTiming::acknowledge_bits, "bits", published, databook_links},
        {group, "time from a byte to its acknowledge", LinkTiming::acknowledge_tenths / 10.0, "bits", fitted, rates},
        {group, "time from an acknowledge to the next byte", LinkTiming::restart_tenths / 10.0, "bits", fitted, rates},
        {group, "additional time before the next byte, at any speed", in_ns(LinkTiming::restart_logic), "ns", fitted,
         "measured data rates, also at 5 and 10 Mbit/s in both directions"},
        {group, "a metre of wire", in_ns(LinkTiming::metre_of_wire), "ns", published,
         "a common figure for transmission lines"},
        {group, "a switch, in one direction", Crossbar::crossing_delay / 100.0, "bits", published, "C004 manual"},
    };
}

std::vector<Constant> of_processors() {
    constexpr std::string_view group = "processor";
    using enum Provenance;
    return {
        {group, "clock, if the netlist states none", in_mega(Processor::usual_clock), "MHz", published,
         "models were sold with 17.5 to 30 MHz"},
        {group, "timeslice period", in_us(Processor::timeslice), "us", published, databook_scheduler},
        {group, "tick at high priority", in_us(Processor::high_tick), "us", published, "INMOS ticks.inc"},
        {group, "tick at low priority", in_us(Processor::low_tick), "us", published, "INMOS ticks.inc"},
        {group, "interrupt of a low-priority process", in_cycles(instructions::preemption), "cycles", published, table},
        {group, "process switch, if the netlist states none", in_cycles(Processor::usual_switching), "cycles", ours,
         "in addition to the instruction that gives up the processor"},
        {group, "access to memory on the chip", in_cycles(Memory::on_chip), "cycles", published, databook_scheduler},
        {group, "access to memory outside of the chip", in_cycles(Memory::outside), "cycles", published,
         "listing of a machine of 64 T800s (ispy)"},
        {group, "access to memory outside of a T2", in_cycles(Memory::outside_of_a_t2), "cycles", published,
         "IMS T225 data sheet; assumed for the T212, T222, M212"},
        {group, "access to memory outside of a T801", in_cycles(Memory::outside_of_a_t801), "cycles", ours,
         "assumed as for a T2, which also has separate address and data buses"},
        {group, "block move, to start", in_cycles(instructions::block_move_start), "cycles", published, table},
    };
}

/// Returns the members of OperationCosts as constants. They are named one by one, so that the compiler reports a
/// missing member. The additional time of a word outside the chip is not listed here, but with the memory accesses.
std::vector<Constant> of_instructions() {
    constexpr std::string_view group = "instructions of a T8";
    const auto& [soft, soft_word, hard, word_outside, copied_word, bytes_in_a_word, start, run, end, read, wait,
                 wait_past, alt, enable, enable_not_ready, enable_timeout, wait_ready, wait_alt, disable,
                 disable_timeout, alt_end, attempt, reset] = instructions::t800;
    using enum Provenance;
    auto row = [group](std::string_view name, Cycles cycles, Provenance mark = published,
                       std::string_view source = table) {
        return Constant{group, name, in_cycles(cycles), "cycles", mark, source};
    };
    return {row("in, out: on a soft channel", soft),
            row("outword, outbyte: a word on a soft channel", soft_word),
            row("in, out: to start a message on a link", hard),
            row("in, out: to copy a word on the chip", copied_word),
            {group, "bytes of a word", static_cast<double>(bytes_in_a_word), "bytes", published, databook_scheduler},
            row("startp: for each component of a PAR but the last", start),
            row("runp: for a component of another priority", run),
            row("endp: each component", end),
            row("ldtimer", read),
            row("tin: a future time", wait),
            row("tin: a past time", wait_past),
            row("alt", alt),
            row("enbc, enbs: for a guard that is ready", enable),
            row("enbc: for a guard that is not ready", enable_not_ready),
            row("enbt", enable_timeout),
            row("altwt: a guard is ready", wait_ready),
            row("altwt: no guard is ready", wait_alt),
            row("disc, diss", disable),
            row("dist", disable_timeout),
            row("altend", alt_end),
            row("a communication that can be given up", attempt, ours,
                "startp, tin and endp, in addition to the usual cost of a communication"),
            row("reset of a channel", reset, ours, "resetch")};
}

std::vector<Constant> of_routers() {
    constexpr std::string_view group = "channels in packets";
    using enum Provenance;
    return {
        {group, "header of a packet", RouterPacket::header_bytes, "bytes", ours,
         "one word for the channel and the kind of packet"},
        {group, "greatest part of a message in a packet", RouterPacket::most_bytes, "bytes", ours,
         "so that a short message waits for at most one packet of a long one"},
        {group, "a packet sent, or received", in_cycles(RouterCosts{}.handling), "cycles", ours,
         "for queueing, looking up the route and rescheduling; if the netlist states none"},
        {group, "packets sent before their acknowledges", Route::most_under_way, "packets", ours,
         "for each channel, at most"},
    };
}

std::vector<Constant> of_buses() {
    constexpr std::string_view group = "VMEbus";
    const auto& [word, byte, arbitration, time_out] = VmeTiming{};
    using enum Provenance;
    return {
        {group, "transfer of a word (D32, ordinary memory)", in_ns(word), "ns", published,
         "textbook figure: 12.9 Mbyte/s"},
        {group, "an access to a register", in_ns(byte), "ns", ours, "as fast as ordinary memory"},
        {group, "arbitration", in_ns(arbitration), "ns", ours, "time from a request or a release to the grant"},
        {group, "time to a bus error", in_us(time_out), "us", published, "a common default value of bus timers"},
    };
}

std::vector<Constant> of_hosts() {
    constexpr std::string_view group = "workstation on a bus";
    constexpr std::string_view of_sgi = "assumed within the range of SGI's table of hosts: 0.2 to 0.75 Mbyte/s";
    const auto& [byte, read, write, in_blocks, interrupt, most_polls] = bus_programs::sun_3_280;
    using enum Provenance;
    return {
        {group, "a byte, in addition to the bus", in_cycles(byte), "cycles", ours, of_sgi},
        {group, "a word read, in addition to the bus", in_cycles(read), "cycles", ours, "SGI's table: about 1 Mbyte/s"},
        {group, "a word written, in addition to the bus", in_cycles(write), "cycles", ours,
         "SGI's table: about 3 Mbyte/s"},
        {group, "time from an interrupt to the process", in_cycles(interrupt), "cycles", ours, "0.1 ms on a Sun 3/280"},
        {group, "most unsuccessful polls of the status", static_cast<double>(most_polls), "times", ours,
         "afterwards the process waits for an interrupt"},
        {group, "tick of its clocks", in_us(Workstation::clock_tick), "us", published,
         "as in a Unix with a clock of 50 Hz"},
    };
}

std::vector<Constant> of_bus_masters() {
    constexpr std::string_view group = "bus master (BBK-V2)";
    const auto& [byte, read, write, in_blocks, interrupt, most_polls] = bus_programs::bbk_v2;
    using enum Provenance;
    return {
        {group, "a byte, in addition to the bus", in_cycles(byte), "cycles", ours, "a loop of lb, sb, cj and lend"},
        {group, "a block read, in addition to the bus", in_cycles(read), "cycles", published, table},
        {group, "a block written, in addition to the bus", in_cycles(write), "cycles", published, table},
        {group, "time from an interrupt to the process", in_cycles(interrupt), "cycles", ours,
         "only the interrupt of a low-priority process, listed above, costs time"},
        {group, "most unsuccessful polls of the status", static_cast<double>(most_polls), "times", ours,
         "afterwards the process waits for an interrupt"},
        {group, "conversion of a word's byte order", in_cycles(bus_programs::conversion), "cycles", ours,
         "if the netlist gives none"},
        {group, "buffer of one direction", MemoryLane::buffer_bytes, "bytes", ours,
         "longer messages are sent in parts"},
    };
}

} // namespace

const char* name_of(Provenance mark) {
    constexpr std::array names{"published", "workload", "calibrated", "ours", "fitted"};
    return names[static_cast<std::size_t>(mark)];
}

std::vector<Constant> constants() {
    std::vector<Constant> all;
    for (auto part : {of_links, of_processors, of_instructions, of_routers, of_buses, of_hosts, of_bus_masters})
        for (const Constant& each : part())
            all.push_back(each);
    return all;
}

} // namespace placedpar::hardware
