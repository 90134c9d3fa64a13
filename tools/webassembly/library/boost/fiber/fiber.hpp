#pragma once

#include <boost/fiber/context.hpp>

#include <memory>
#include <utility>

namespace boost::fibers {

enum class launch { post };

class fiber {
public:
    template <class Allocator, class Body>
    fiber(launch, std::allocator_arg_t, Allocator memory, Body body) {
        context::algorithm()->awakened(new context(memory.allocate(), std::move(body)));
    }
    void detach() {}
};

} // namespace boost::fibers
