#include "classics/kinds.hpp"

#include "netlist/kinds/catalogue.hpp"

#include <utility>

namespace placedpar {

void add_classical_kinds(Catalogue& catalogue) {
    for (auto kinds :
         {philosopher_kinds(), sieve_kinds(), matrix_kinds(), farm_kinds(), bounded_buffer_kinds(), task_kinds()})
        for (auto& kind : kinds)
            catalogue.add(std::move(kind));
}

} // namespace placedpar
