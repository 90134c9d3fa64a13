#pragma once

#include "runtime/carrier.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {
class Kernel;
class Process;
} // namespace placedpar

namespace placedpar::hardware {

/// A link adapter (IMS C011, C012), by which a program on a bus sends and receives the bytes of a link. It has a
/// register for a byte of output, a register for a byte of input, and a status register for each of them. It
/// acknowledges an input byte only when a program reads it from the register (Helios-NG sources). So the link must have
/// a timing without overlapped acknowledges.
class LinkAdapter final : public BusSlave {
public:
    /// The end of the link at which the adapter is. A transputer is at the other end. REQUIRES: the link outlives the
    /// adapter.
    enum class End { a, b };
    LinkAdapter(Kernel&, std::string name, Link&, End);

    const std::string& bus_name() const override { return name_; }
    LinkDirection& to_link() const { return to_link_; }
    LinkDirection& from_link() const { return from_link_; }

private:
    friend class AdapterProgram;

    /// One of the two data registers, with the process that waits for its interrupt.
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

/// The program by which a bus master, such as a host computer, sends and receives messages at an adapter. For each byte
/// the program reads the status register until the data register is ready, then writes or reads the byte. After
/// BusProgram::most_polls unsuccessful reads of the status, the program waits for the adapter's interrupt. Each access
/// to a register takes time of the program and a cycle of the bus.
///
/// If a process gives up its message (runtime/recovery.hpp), the program abandons the message after the current access.
class AdapterProgram {
public:
    /// REQUIRES: master and adapter outlive the program, and no other master uses the adapter. The processes that
    /// output by to_link() and input by from_link() are on the master.
    AdapterProgram(Kernel&, VmeMaster&, LinkAdapter&);

    /// Return the carriers of the two directions: from a process on the master to a process on the transputer behind
    /// the link, and back.
    Carrier& to_link() { return to_link_; }
    Carrier& from_link() { return from_link_; }

private:
    friend class AdapterBroadcast;

    /// The common part of both directions. At the other end of the link an engine moves the bytes.
    struct AdapterLane : Carrier {
        AdapterLane(AdapterProgram& p, LinkDirection& l) : program(p), link(l) {}
        bool message_waits(const AnyChannel& c) const override { return link.message_waits(c); }
        bool output_is_lost(const AnyChannel& c) const override { return link.output_is_lost(c); }
        bool input_is_lost(const AnyChannel& c) const override { return link.input_is_lost(c); }
        bool output_must_be_reset(const AnyChannel& c) const override { return link.output_must_be_reset(c); }
        bool input_must_be_reset(const AnyChannel& c) const override { return link.input_must_be_reset(c); }
        std::string why_not_given_up() const override { return ""; }
        bool give_up_output(AnyChannel& c) override { return link.give_up_output(c); }
        bool give_up_input(AnyChannel& c) override { return link.give_up_input(c); }
        std::uint64_t reset_output(AnyChannel& c) override { return link.reset_output(c); }
        std::uint64_t reset_input(AnyChannel& c) override { return link.reset_input(c); }
        AdapterProgram& program;
        LinkDirection& link;
    };
    struct ToLink final : AdapterLane {
        using AdapterLane::AdapterLane;
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel& c, const SourceLocation& where) override { link.input(c, where); }
        void write_part(AnyChannel&, std::uint32_t bytes, bool last, const SourceLocation&);
    };
    struct FromLink final : AdapterLane {
        using AdapterLane::AdapterLane;
        void output(AnyChannel& c, const WireForm& form, const SourceLocation& where) override {
            link.output(c, form, where);
        }
        void input(AnyChannel&, const SourceLocation&) override;
    };

    void access();
    template <class Over>
    void poll(LinkAdapter::Register&, Activity, AnyChannel&, const SourceLocation&, Over);
    void wait_until_writable(AnyChannel&, const SourceLocation&);
    void wait_until_readable(AnyChannel&, const SourceLocation&);

    Kernel& kernel_;
    VmeMaster& master_;
    LinkAdapter& adapter_;
    ToLink to_link_{*this, adapter_.to_link()};
    FromLink from_link_{*this, adapter_.from_link()};
};

/// Thrown if a program outputs different messages to the lanes of a broadcast.
class BroadcastError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Sends one message to the transputers at several link adapters: a single write on the bus reaches the output
/// registers of all of them. A program outputs the message in a PAR, on one channel for each adapter. The component
/// that comes last writes the bytes. It writes a byte when all status registers have shown that the output registers
/// are free.
///
/// 1. Call carry() for each adapter before the run.
/// 2. The messages that a program outputs on the channels must be equal. A process that outputs a different message
/// gets a BroadcastError. If messages of the protocol cannot be compared (SameMessage), every process gets a
/// BroadcastError.
class AdapterBroadcast {
public:
    /// REQUIRES: at least one program, and all programs have the same master. Throws std::logic_error otherwise.
    AdapterBroadcast(Kernel&, const std::vector<AdapterProgram*>&);

    /// Makes the channel lead to the transputer of adapter i. REQUIRES: i < adapters(); the channel outlives the run.
    void carry(AnyChannel& channel, std::size_t i);
    std::size_t adapters() const { return lanes_.size(); }
    /// Return the number of complete messages, and of their bytes. A message to all adapters counts once.
    std::uint64_t messages() const { return messages_; }
    std::uint64_t bytes() const { return bytes_; }

private:
    struct Lane final : Carrier {
        Lane(AdapterBroadcast& b, AdapterProgram& p) : broadcast(b), program(p) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel&, const SourceLocation&) override;
        bool message_waits(const AnyChannel&) const override;
        bool output_is_lost(const AnyChannel&) const override;
        bool input_is_lost(const AnyChannel&) const override;
        std::string why_not_given_up() const override { return "is broadcast with other channels"; }
        std::vector<const AnyChannel*> held_up_by(const AnyChannel&) const override;
        const LinkDirection& link() const { return program.adapter_.to_link(); }
        bool holds_others_up() const;
        AdapterBroadcast& broadcast;
        AdapterProgram& program;
        AnyChannel* channel = nullptr;
        Process* outputter = nullptr; ///< waits until the message has been written
    };
    bool is_written() const { return waiting_ == lanes_.size(); }
    void require_same(const AnyChannel&, const WireForm&);
    void write_all(const WireForm&, const SourceLocation&);
    void write_part(std::uint32_t bytes, bool last, const SourceLocation&);
    void wait_for_all(const SourceLocation&);
    void let_others_go_on();

    Kernel& kernel_;
    std::vector<Lane> lanes_;
    std::size_t waiting_ = 0;
    const AnyChannel* first_ = nullptr; ///< channel whose process came first
    std::optional<WireForm> form_;      ///< form of the message on this channel
    std::uint64_t messages_ = 0, bytes_ = 0;
};

} // namespace placedpar::hardware
