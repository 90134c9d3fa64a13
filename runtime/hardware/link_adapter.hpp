#pragma once

#include "runtime/carrier.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {
class Kernel;
class Process;
} // namespace placedpar

namespace placedpar::hardware {

/// A link adapter (IMS C011, C012) between a link and a bus: registers for a byte of output, a byte of input, and the
/// status of each. It does not overlap acknowledges: a byte that comes in is acknowledged when it is read from its
/// register (Helios-NG sources), so the link's timing must say so, too.
class LinkAdapter final : public BusSlave {
public:
    /// At that end of the link, of which the other is a transputer's. REQUIRES: the link outlives it.
    enum class End { a, b };
    LinkAdapter(Kernel&, std::string name, Link&, End);

    const std::string& bus_name() const override { return name_; }
    LinkDirection& to_link() const { return to_link_; }
    LinkDirection& from_link() const { return from_link_; }

private:
    friend class AdapterProgram;

    /// One of the two registers for data, and the process that waits for its interrupt.
    struct Register final : RegisterUser {
        explicit Register(Kernel& k) : kernel(k) {}
        void register_ready() override;
        Kernel& kernel;
        Process* sleeper = nullptr;
    };

    std::string name_;
    LinkDirection &to_link_, &from_link_;
    Register output_, input_;
};

/// How a master sends and receives messages by an adapter: it reads the status register until the data register is
/// ready, then writes or reads a byte, for each byte of the message. A process that has read the status in vain for
/// BusProgram::most_polls times waits for the adapter's interrupt. Each access costs the program its time and the bus a
/// cycle.
class AdapterProgram {
public:
    /// REQUIRES: they outlive it, no other master uses the adapter, and the processes that output by to_link() and
    /// input by from_link() are executed by what the master belongs to.
    AdapterProgram(Kernel&, VmeMaster&, LinkAdapter&);

    /// For channels from a process on the master to one on the transputer at the other end of the link, and back.
    Carrier& to_link() { return to_link_; }
    Carrier& from_link() { return from_link_; }

private:
    friend class AdapterBroadcast;

    struct ToLink final : Carrier {
        explicit ToLink(AdapterProgram& p) : program(p) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel&, const SourceLocation&) override;
        bool message_waits(const AnyChannel&) const override;
        AdapterProgram& program;
    };
    struct FromLink final : Carrier {
        explicit FromLink(AdapterProgram& p) : program(p) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel&, const SourceLocation&) override;
        bool message_waits(const AnyChannel&) const override;
        AdapterProgram& program;
    };

    void access();
    template <class Ready>
    void poll(LinkAdapter::Register&, Activity, AnyChannel&, const SourceLocation&, Ready);
    void wait_until_writable(AnyChannel&, const SourceLocation&);
    void wait_until_readable(AnyChannel&, const SourceLocation&);

    Kernel& kernel_;
    VmeMaster& master_;
    LinkAdapter& adapter_;
    ToLink to_link_{*this};
    FromLink from_link_{*this};
};

/// The same message to the transputers at several adapters at once: one write to the bus reaches the output registers
/// of them all. A program outputs it in a PAR, on a channel for each adapter; the component that comes last writes the
/// bytes, when the status of each adapter in turn has shown that its register is free.
class AdapterBroadcast {
public:
    /// REQUIRES: at least one program, all of one master. Throws std::logic_error otherwise.
    AdapterBroadcast(Kernel&, const std::vector<AdapterProgram*>&);

    /// For the channel to the transputer of adapter number i.
    Carrier& lane(std::size_t i) { return lanes_[i]; }
    std::uint64_t messages() const { return messages_; }

private:
    struct Lane final : Carrier {
        Lane(AdapterBroadcast& b, AdapterProgram& p) : broadcast(b), program(p) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel&, const SourceLocation&) override;
        bool message_waits(const AnyChannel&) const override;
        AdapterBroadcast& broadcast;
        AdapterProgram& program;
        AnyChannel* channel = nullptr; ///< while an output waits
        Process* outputter = nullptr;
    };
    void write_all(const WireForm&, const SourceLocation&);
    void write_part(std::uint32_t bytes, bool last, const SourceLocation&);
    void wait_for_all(const SourceLocation&);
    void let_others_go_on();

    Kernel& kernel_;
    std::vector<Lane> lanes_;
    std::size_t waiting_ = 0;
    std::vector<WireForm> forms_; ///< of the messages that wait
    std::uint64_t messages_ = 0;
};

} // namespace placedpar::hardware
