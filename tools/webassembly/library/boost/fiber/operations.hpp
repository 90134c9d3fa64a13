#pragma once

#include <boost/fiber/context.hpp>

#include <memory>
#include <type_traits>
#include <utility>

namespace boost::fibers {

template <class Algorithm, class... Arguments>
void use_scheduling_algorithm(Arguments&&... arguments) {
    if constexpr (std::is_same_v<Algorithm, algo::round_robin>)
        context::algorithm() = nullptr;
    else
        context::algorithm() = std::make_unique<Algorithm>(std::forward<Arguments>(arguments)...);
}

} // namespace boost::fibers
