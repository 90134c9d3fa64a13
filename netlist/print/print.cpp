#include "netlist/print/print.hpp"

namespace placedpar {

std::uint64_t network_hash(std::string_view canonical, std::uint64_t before) {
    std::uint64_t hash = before;
    for (char c : canonical) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U; // the prime of FNV-1a
    }
    return hash;
}

std::uint64_t boot_hash(const Node& node) {
    return network_hash({reinterpret_cast<const char*>(node.boot_bytes->data()), node.boot_bytes->size()});
}

} // namespace placedpar
