#pragma once

#include "runtime/user_code.hpp"
#include "text/user_error.hpp"

#include <string>

namespace placedpar {

/// What `work`, code that a program adds, gives. Throws UserError for whatever it throws: whose() and what was thrown.
template <class Whose, class Work>
auto tried(const Whose& whose, const Work& work) {
    try {
        return work();
    } catch (...) {
        throw UserError(std::string(whose()) + ": " + what_was_thrown());
    }
}

} // namespace placedpar
