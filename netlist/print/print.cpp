#include "netlist/print/print.hpp"

namespace placedpar {

std::uint64_t network_hash(std::string_view canonical) {
    std::uint64_t hash = 0xcbf29ce484222325U; // offset and prime of FNV-1a, 64 bits
    for (char c : canonical) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return hash;
}

} // namespace placedpar
