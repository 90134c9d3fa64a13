#include "placedpar/explore/load.hpp"
#include "placedpar/identification/identification.hpp"
#include "placedpar/monitor/service/service.hpp"

/// A program that uses the monitor would begin with such a function.
std::size_t samples_needed(const placedpar::monitor::ServiceSettings& service) {
    return service.diagnosis.search.window.length +
           placedpar::identification::samples_for_first_generation(placedpar::identification::thesis_way());
}
