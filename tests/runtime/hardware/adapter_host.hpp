#pragma once

#include "runtime/hardware/bus_programs.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/workstation.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <vector>

namespace placedpar::test {

using Octets = std::vector<std::uint8_t>;
inline constexpr hardware::LinkTiming adapter_timing{.overlapped_acknowledge = false};

/// A Sun with a link adapter on its bus; the adapter's link leads to a transputer.
struct Host {
    explicit Host(std::int64_t most_polls = 32, const hardware::LinkTiming& timing = adapter_timing)
        : program(hardware::bus_programs::sun_3_280),
          link(simulation.add<hardware::Link>(timing, "adapter.link[0]", "t800.link[0]")) {
        program.most_polls = most_polls;
    }

    Simulation simulation;
    hardware::BusProgram program;
    hardware::VmeBus& bus = simulation.add<hardware::VmeBus>("bus");
    hardware::Workstation& sun = simulation.add<hardware::Workstation>("sun");
    hardware::VmeMaster& master = simulation.add<hardware::VmeMaster>("sun", bus, hardware::VmePlace{}, program);
    hardware::Processor& t800 = simulation.add<hardware::Processor>("t800");
    hardware::Link& link;
    hardware::LinkAdapter& adapter =
        simulation.add<hardware::LinkAdapter>("adapter", link, hardware::LinkAdapter::End::a);
    hardware::AdapterProgram& driver = simulation.add<hardware::AdapterProgram>(master, adapter);
};

} // namespace placedpar::test
