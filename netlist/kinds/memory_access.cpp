#include "netlist/kinds/memory_access.hpp"

#include "netlist/kinds/computer.hpp"
#include "runtime/hardware/processor.hpp"

namespace placedpar {

Cycles access_time(const Node& node) {
    using hardware::Memory;
    if (std::int64_t stated = node.integer("memorycycles"))
        return Cycles{stated};
    if (node.integer("memory") <= 4 * kilobyte)
        return Memory::on_chip;
    if (has_short_words(node.type))
        return Memory::outside_of_a_t2;
    return node.type == "T801" ? Memory::outside_of_a_t801 : Memory::outside;
}

} // namespace placedpar
