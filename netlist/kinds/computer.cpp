#include "netlist/kinds/computer.hpp"

#include "netlist/kinds/description.hpp"
#include "runtime/hardware/processor.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr double largest_address_space = 4294967296.0;
constexpr double highest_frequency = 1e9;

/// Returns the size as "2 MB" or "4 KB"; "" for no memory.
std::string bytes(const Value& value) {
    auto size = std::get<std::int64_t>(value);
    if (size <= 0)
        return "";
    if (size % megabyte == 0)
        return fmt::format("{} MB", size / megabyte);
    if (size % kilobyte == 0)
        return fmt::format("{} KB", size / kilobyte);
    return fmt::format("{} bytes", size);
}

} // namespace

std::string megahertz(const Value& frequency) {
    return fmt::format("{:g} MHz", static_cast<double>(std::get<std::int64_t>(frequency)) / 1e6);
}

std::vector<AttributeDescription> computer_attributes() {
    using namespace description;
    return {
        {.value = integer("memory", {.unit = "bytes", .by_default = 0, .least = 1, .most = largest_address_space},
                          "size of the memory; default: the memory of the chip or module"),
         .json_name = "memory_bytes",
         .drawn = bytes},
        {.value = integer(
             "clock",
             {.unit = "Hz", .by_default = hardware::Processor::usual_clock, .least = 1, .most = highest_frequency},
             "clock frequency"),
         .decimal_suffixes = true,
         .json_name = "clock_hz"},
        {.value = integer(
             "linkspeed",
             {.unit = "bit/s", .by_default = hardware::LinkTiming::usual_speed, .least = 1, .most = highest_frequency},
             "speed of the links, unless the connection states it"),
         .decimal_suffixes = true,
         .json_name = "link_bits_per_second"},
        {.value = integer("channelcall", {.unit = "cycles", .by_default = 0, .least = 0, .most = highest_frequency},
                          "cost of a channel operation in the communication library"),
         .json_name = "channel_call_cycles"},
    };
}

std::vector<std::string> attributes_of_the_real_tool() {
    return {"reserved", "linkquota", "tolerance", "nodebug", "noprofile", "pagesize"};
}

} // namespace placedpar
