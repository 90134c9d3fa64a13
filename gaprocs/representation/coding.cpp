#include "gaprocs/representation/coding.hpp"

namespace placedpar {

std::optional<Coding> coding_named(std::string_view name) {
    for (Coding coding : {Coding::natural, Coding::gray})
        if (name == name_of(coding))
            return coding;
    return std::nullopt;
}

} // namespace placedpar
