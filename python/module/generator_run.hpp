#pragma once

#include "python/module/operation.hpp"
#include "runtime/alternation.hpp"

#include <list>
#include <string>
#include <vector>

namespace placedpar::python {

/// Runs the generator of a body, or of a component of a PAR, as the running process.
class GeneratorRun {
public:
    GeneratorRun() = default;
    GeneratorRun(const GeneratorRun&) = delete;
    GeneratorRun& operator=(const GeneratorRun&) = delete;
    ~GeneratorRun();

    /// Does all operations. REQUIRES: start() was called.
    void finish();
    /// REQUIRES: the caller holds the lock, in Interpreter::call().
    void start(pybind11::object component);

private:
    void step(pybind11::object answer);
    void fail(const std::string& why);
    bool take(PySendResult, PyObject* yielded);
    void prepare();
    void carry_out();
    void answer();
    void alternate();
    Guard guard_of(pybind11::handle) const;
    void begin_components();
    void run_components();
    pybind11::object result_of_operation();

    Interpreter& python_ = Interpreter::current();
    pybind11::object generator_; ///< null if a single operation is to be done
    pybind11::object operation_; ///< of the generator
    Operation* now_ = nullptr;
    pybind11::object result_; ///< of the generator, once it has ended
    std::vector<Guard> guards_;
    std::vector<ChannelEnd*> guarded_; ///< for each guard the end that it guards, or null
    std::size_t chosen_ = 0;
    std::list<GeneratorRun> components_;
    std::string refused_; ///< why the operation failed; "" if it did not
};

} // namespace placedpar::python
