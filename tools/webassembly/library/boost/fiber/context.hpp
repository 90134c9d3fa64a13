#pragma once

// The part of Boost.Fiber that runtime/ uses, on the fibers of Emscripten. Boost has no switch of stacks for
// WebAssembly.

#include <emscripten/fiber.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace boost::context {

struct stack_context {
    std::size_t size = 0;
    void* sp = nullptr;
};

} // namespace boost::context

namespace boost::fibers {

class context;

namespace algo {

class algorithm {
public:
    virtual ~algorithm() = default;
    virtual void awakened(context*) noexcept = 0;
    virtual context* pick_next() noexcept = 0;
    virtual bool has_ready_fibers() const noexcept = 0;
    virtual void suspend_until(std::chrono::steady_clock::time_point const&) noexcept = 0;
    virtual void notify() noexcept = 0;
};
class round_robin;

} // namespace algo

class context {
public:
    /// Returns the fiber that runs.
    static context* active() {
        static context first;
        if (!running())
            running() = &first;
        return running();
    }
    context() { emscripten_fiber_init_from_current_context(&fiber_, frames_.data(), frames_.size()); }
    context(const boost::context::stack_context& stack, std::function<void()> body);
    void resume() {
        context* const from = std::exchange(running(), this);
        emscripten_fiber_swap(&from->fiber_, &fiber_);
    }
    void worker_unlink() { delete this; }

    static std::unique_ptr<algo::algorithm>& algorithm() {
        static std::unique_ptr<algo::algorithm> one;
        return one;
    }

private:
    static constexpr std::size_t bytes_of_frames = 64 << 10; ///< WebAssembly's own frames, when the fiber rests

    static context*& running() {
        static context* one = nullptr;
        return one;
    }

    emscripten_fiber_t fiber_ = {};
    std::function<void()> body_;
    std::vector<std::byte> frames_ = std::vector<std::byte>(bytes_of_frames);
};

inline context::context(const boost::context::stack_context& stack, std::function<void()> body)
    : body_(std::move(body)) {
    emscripten_fiber_init(
        &fiber_, [](void* self) { static_cast<context*>(self)->body_(); }, this,
        static_cast<std::byte*>(stack.sp) - stack.size, stack.size, frames_.data(), frames_.size());
}

} // namespace boost::fibers
