#pragma once

#include <boost/context/fiber.hpp>
#include <pybind11/pybind11.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <string>

namespace placedpar::python {

/// A reference to a Python object, which may be copied and destroyed without Python's global lock, here called the
/// lock.
class SharedObject {
public:
    SharedObject() = default;
    /// REQUIRES: the caller holds the lock.
    explicit SharedObject(pybind11::object object)
        : object_(object.release().ptr(), [](PyObject* held) {
              const pybind11::gil_scoped_acquire lock;
              Py_DECREF(held);
          }) {}
    pybind11::handle get() const { return object_.get(); }

private:
    std::shared_ptr<PyObject> object_;
};

/// The virtual time of a run at its latest generation, or at the latest step of a process in Python. Other threads may
/// read the time.
struct RunClock {
    std::atomic<std::int64_t> picoseconds{0};
};

/// Calls Python for the processes of one run of a network. The run holds the lock only during the calls. The calls use
/// a separate stack, because Python needs more than the stack of a process.
///
/// 1. Only one object exists on a thread at a time; current() returns it.
/// 2. All calls are made on the thread of the run.
class Interpreter {
public:
    Interpreter();
    ~Interpreter();
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;
    /// Returns the interpreter of this thread. REQUIRES: there is one.
    static Interpreter& current();

    /// Calls `work` with the lock, and rethrows what it throws. Throws a Python exception as a std::runtime_error with
    /// its type and text, and keeps the first such exception for failure().
    template <class Work>
    void call(Work work) {
        call({[](void* it) { (*static_cast<Work*>(it))(); }, &work});
    }
    /// Returns the first exception of Python; null if there was none.
    const SharedObject& failure() const { return failure_; }

    /// For each unfinished process, the place in its program at which it waited, such as "relay.py:12".
    std::map<std::string, std::string> places;
    RunClock* clock = nullptr; ///< receives the time of the run; null: no other thread reads the time

private:
    struct Call {
        void (*function)(void*);
        void* argument;
    };
    void call(Call);
    void make_call() noexcept;
    void keep(const pybind11::error_already_set&);

    SharedObject failure_;
    Call call_{};
    bool is_inside_ = false;
    std::exception_ptr thrown_;
    boost::context::fiber stack_;
};

/// Lets Python handle signals that have arrived, such as SIGINT, and throws the exceptions of their handlers. REQUIRES:
/// the caller holds the lock.
inline void heed_signals() {
    if (PyErr_CheckSignals() != 0)
        throw pybind11::error_already_set();
}

/// Returns a class of placedpar.errors, such as "Error". REQUIRES: the caller holds the lock.
inline pybind11::object error_named(const char* name) {
    return pybind11::module_::import("placedpar.errors").attr(name);
}

/// Returns the type and the text of a Python exception, such as "ValueError: too long". REQUIRES: the caller holds the
/// lock.
std::string text_of(pybind11::handle exception);

/// Throws an exception of the class `error_class` of placedpar.errors, with `failure` as its cause. If `failure` is a
/// KeyboardInterrupt or SystemExit, throws it unchanged. REQUIRES: the caller holds the lock.
[[noreturn]] void rethrow(const SharedObject& failure, const char* error_class, const std::string& text);

} // namespace placedpar::python
