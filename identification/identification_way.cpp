#include "identification/identification_way.hpp"

#include <algorithm>

namespace placedpar::identification {

std::size_t samples_for_first_generation(const IdentificationWay& way) {
    return std::min(way.search.window.first, way.search.window.length);
}

IdentificationWay thesis_way() { return {}; }

IdentificationWay rising_way() {
    IdentificationWay way = thesis_way();
    way.usable.rising = true;
    return way;
}

} // namespace placedpar::identification
