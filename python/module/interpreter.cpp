#include "python/module/interpreter.hpp"

#include <boost/context/protected_fixedsize_stack.hpp>

#include <stdexcept>
#include <utility>

namespace placedpar::python {

namespace {

thread_local Interpreter* current_interpreter = nullptr;

/// A page of the stack takes memory only once it has been used.
constexpr std::size_t stack_bytes = 16 * 1024 * 1024;

} // namespace

Interpreter::Interpreter() {
    if (current_interpreter)
        throw std::runtime_error("a process cannot run another network: run it before or after this run");
    stack_ = boost::context::fiber(std::allocator_arg, boost::context::protected_fixedsize_stack(stack_bytes),
                                   [this](boost::context::fiber&& caller) {
                                       while (call_.function) {
                                           make_call();
                                           caller = std::move(caller).resume();
                                       }
                                       return std::move(caller);
                                   });
    current_interpreter = this;
}

Interpreter::~Interpreter() {
    current_interpreter = nullptr;
    call_ = {};
    if (stack_)
        stack_ = std::move(stack_).resume();
}

Interpreter& Interpreter::current() {
    if (!current_interpreter)
        throw std::logic_error("a process in Python runs outside Interpreter::call()");
    return *current_interpreter;
}

void Interpreter::call(Call call) {
    if (is_inside_) // Python has called the caller, so the lock is held already
        return call.function(call.argument);
    call_ = call;
    stack_ = std::move(stack_).resume();
    if (thrown_)
        std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Interpreter::make_call() noexcept {
    const pybind11::gil_scoped_acquire lock;
    is_inside_ = true;
    try {
        call_.function(call_.argument);
    } catch (pybind11::error_already_set& error) {
        keep(error);
    } catch (const pybind11::builtin_exception& error) {
        error.set_error();
        keep(pybind11::error_already_set());
    } catch (...) {
        thrown_ = std::current_exception();
    }
    is_inside_ = false;
}

void Interpreter::keep(const pybind11::error_already_set& error) {
    const pybind11::object exception = error.value();
    exception.attr("__traceback__") = error.trace() ? error.trace() : pybind11::none();
    if (!failure_.get())
        failure_ = SharedObject(exception);
    thrown_ = std::make_exception_ptr(std::runtime_error(text_of(exception)));
}

std::string text_of(pybind11::handle exception) {
    const auto type = pybind11::str(pybind11::type::of(exception).attr("__name__")).cast<std::string>();
    const auto text = pybind11::str(exception).cast<std::string>();
    return text.empty() ? type : type + ": " + text;
}

void rethrow(const SharedObject& failure, const char* error_class, const std::string& text) {
    auto thrown = pybind11::reinterpret_borrow<pybind11::object>(failure.get());
    if (PyErr_GivenExceptionMatches(thrown.ptr(), PyExc_Exception) != 0) {
        const pybind11::object error = error_named(error_class)(text);
        error.attr("__cause__") = thrown;
        thrown = error;
    }
    PyErr_SetObject(pybind11::type::of(thrown).ptr(), thrown.ptr());
    throw pybind11::error_already_set();
}

} // namespace placedpar::python
