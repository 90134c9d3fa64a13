#pragma once

#include "runtime/carrier.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <string>

namespace placedpar {
class Kernel;
class Process;
} // namespace placedpar

namespace placedpar::hardware {

/// A memory with two ports on a VMEbus board. The board's transputer uses one port. Bus masters, such as the host
/// computer, reach the other port over the bus. The board BBK-V2 has 2 Mbyte of this memory (thesis, appendix D).
class DualPortedMemory final : public BusSlave {
public:
    DualPortedMemory(Kernel&, std::string name) : name_(std::move(name)) {}
    const std::string& bus_name() const override { return name_; }

private:
    std::string name_;
};

/// Carries messages in one direction between a process on a bus master and a process on the transputer of a dual-ported
/// memory. Messages go through a buffer in the memory, one at a time. The master moves the words over the bus. The
/// transputer copies them between the buffer and its process's memory. The transputer also swaps bytes if the master's
/// byte order differs: a 68020 is big endian, and a T800 is little endian. When an end has filled or emptied the
/// buffer, it interrupts the other end.
class MemoryLane final : public Carrier {
public:
    /// The size of the buffer for one direction, in bytes (our choice). A longer message is moved in parts.
    static constexpr std::int64_t buffer_bytes = 65536;

    /// The end that outputs: the bus master, or the transputer that owns the memory.
    enum class From { master, memory };
    /// `conversion`: the transputer's cycles for swapping the bytes of a word; 0 if both computers have the same byte
    /// order. REQUIRES: master and memory outlive the lane, and execute the processes at their ends.
    MemoryLane(Kernel&, VmeMaster&, DualPortedMemory&, From, Cycles conversion);

    std::string why_not_given_up() const override { return "leads through the memory of a bus master"; }
    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return full_; }

private:
    static std::uint64_t words_in(std::int64_t bytes) { return static_cast<std::uint64_t>((bytes + 3) / 4); }
    void move_over_bus(std::int64_t bytes, Cycles word);
    void copy_in_memory(std::int64_t bytes);
    void fill(std::int64_t bytes);
    void empty(std::int64_t bytes);
    void wait_until(bool full, Activity, AnyChannel&, const SourceLocation&, bool master);
    void turn(bool full);

    Kernel& kernel_;
    VmeMaster& master_;
    DualPortedMemory& memory_;
    From from_;
    Cycles conversion_;
    bool full_ = false;          ///< the buffer holds a part of a message
    std::int64_t bytes_ = 0;     ///< length of this part in bytes
    bool last_ = false;          ///< the part is the last of its message
    Process* waiting_ = nullptr; ///< the process that waits for the buffer
};

} // namespace placedpar::hardware
