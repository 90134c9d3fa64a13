#pragma once

#include "netlist/kinds/boot_host.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/listing.hpp"
#include "runtime/transputer/message_end.hpp"
#include "runtime/transputer/node.hpp"
#include "runtime/transputer/stepper.hpp"
#include "runtime/transputer/waiting.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>

namespace placedpar {

class OutsideHost; // netlist/kinds/outside_host.hpp

/// Returns the options with which an iserver, the host's part, serves the program in the bootable file `file`.
iserver::ServerOptions server_options(const HostServices&, const std::string& file);

/// Simulates a transputer that executes machine code, instruction by instruction. If the netlist names a bootable file
/// for the transputer, a host at one of its links sends the file, then answers the program's requests.
class BootedNode final : public MachineNode {
public:
    BootedNode(MachineParts&, std::size_t node);
    ~BootedNode() override;

    void has_link(hardware::Link&) override;
    void report(MachineUse&) const override;
    std::vector<ProgramWait> program_waits() const override;
    void carry(AnyChannel&, const RouteHop&) override;
    void shuffle(std::uint64_t seed) override;
    FaultEffects suffer(const Fault& halts) override;

    transputer::Node& device() { return device_; }

private:
    struct Host;
    bool has_ended() const;
    void await_end();
    void notice_end();
    void watch_code();
    void tell_hosts();
    std::string state() const;
    std::string state_of_program() const;
    const transputer::CodeLines& lines() const;
    std::vector<ProgramUse::Stop> stops() const;
    std::vector<transputer::WaitingProcess> waiting_processes() const;
    ProgramWait describe(const transputer::WaitingProcess&) const;
    void connect_host(hardware::Link&, const LinkEnd& own, bool own_is_a);
    transputer::MessageEnd& message_end(std::size_t connection);

    transputer::Node& device_;
    hardware::Link* last_link_ = nullptr; ///< argument of the last call of has_link()
    std::vector<std::unique_ptr<transputer::ByteLink>> lanes_;
    std::map<std::size_t, transputer::MessageEnd>
        message_ends_; ///< far ends of wires, at which processes of the netlist output and input; key: index in
                       ///< Network::connections
    std::unique_ptr<transputer::Listing> listing_;
    std::unique_ptr<transputer::Stepper> stepper_;
    std::unique_ptr<Host> host_;
    Process* awaits_end_ = nullptr; ///< for a transputer with an image (Node::image): process that keeps the run going
                                    ///< until the image's processes have ended; null otherwise
    std::unique_ptr<OutsideHost>
        outside_; ///< used in place of `host_` if a program outside the simulation acts as the host
};

} // namespace placedpar
