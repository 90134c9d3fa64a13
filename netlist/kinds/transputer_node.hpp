#pragma once

#include "netlist/kinds/machine_node.hpp"
#include "runtime/hardware/processor.hpp"

namespace placedpar {

/// Simulates a transputer that executes processes in C++, which state how long they compute. The processor and the
/// links share its memory.
class TransputerNode : public MachineNode {
public:
    TransputerNode(MachineParts&, std::size_t node);

    Executive* executive() override { return &processor_; }
    void has_link(hardware::Link& link) override { processor_.has_link(link); }
    FaultEffects suffer(const Fault&) override;
    void report(MachineUse&) const override;

protected:
    hardware::RouterCosts router_costs() const override;

private:
    hardware::Processor& processor_;
};

} // namespace placedpar
