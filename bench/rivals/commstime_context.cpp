// This program runs COMMSTIME on bare contexts of Boost.Context, without Boost.Fiber: a switch costs only the jump.

#include "least_stackful.hpp"

#include <boost/context/detail/fcontext.hpp>
#include <boost/context/fixedsize_stack.hpp>

#include <cstdlib>
#include <functional>

namespace {

using namespace boost::context::detail;

struct Context {
    fcontext_t stack = nullptr; ///< place at which the context was left
    std::function<void()> body;
};

/// Jumps to a context, and stores the place at which the present context was left.
void jump(Context& next) {
    static Context host;
    static Context* running = &host;
    Context* from = running;
    running = &next;
    transfer_t came = jump_fcontext(next.stack, from);
    static_cast<Context*>(came.data)->stack = came.fctx;
}

LeastKernel<Context, jump> kernel;

void begin(transfer_t came) {
    static_cast<Context*>(came.data)->stack = came.fctx;
    kernel.running().body();
}

} // namespace

int main(int argc, char** argv) {
    long loops = argc > 1 ? std::atol(argv[1]) : 1'000'000;
    measure<kernel>("least on bare contexts", loops, argc > 2, [](auto body) {
        auto* context = new Context{nullptr, body};
        boost::context::stack_context stack = boost::context::fixedsize_stack().allocate();
        context->stack = make_fcontext(stack.sp, stack.size, begin);
        kernel.make_ready(*context);
    });
}
