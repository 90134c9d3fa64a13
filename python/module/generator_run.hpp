#pragma once

#include "python/module/operation.hpp"
#include "runtime/alternation.hpp"

#include <list>
#include <memory>
#include <string>
#include <vector>

namespace placedpar::python {

/// Runs a Python generator as a process. The generator is the body of a process, or of a component of a PAR, and yields
/// one operation, such as an input, after the other.
class GeneratorRun {
public:
    GeneratorRun() = default;
    GeneratorRun(const GeneratorRun&) = delete;
    GeneratorRun& operator=(const GeneratorRun&) = delete;
    ~GeneratorRun();

    /// Performs all operations until the generator ends. REQUIRES: start() was called.
    void finish();
    /// Sets what to run: a generator, or a single operation of the generator `enclosing`. REQUIRES: the caller holds
    /// Python's global lock, in Interpreter::call().
    void start(pybind11::object component, const pybind11::object& enclosing);

private:
    void note_place() const;
    void step(pybind11::object answer);
    void prepare_or_fail();
    void fail(const pybind11::object& error);
    bool take(PySendResult, PyObject* yielded);
    void prepare();
    void carry_out();
    void answer();
    void alternate();
    void prepare_guards();
    Guard guard_of(pybind11::handle) const;
    void begin_components();
    void run_components();
    pybind11::object result_of_operation();

    Interpreter& python_ = Interpreter::current();
    pybind11::object generator_; ///< null if this object runs a single operation
    pybind11::object where_;     ///< the generator whose current line is reported as the place of this run
    pybind11::object operation_; ///< the operation that the generator yielded last
    Operation* now_ = nullptr;
    pybind11::object result_; ///< the generator's return value, once it has ended
    std::vector<Guard> guards_;
    /// The input end of each guard of the ALT; null for a guard that is not an input.
    std::vector<std::shared_ptr<ChannelEnd>> guarded_;
    std::size_t chosen_ = 0;
    std::list<GeneratorRun> components_;
    std::string refused_; ///< why the operation failed; "" if it did not
};

} // namespace placedpar::python
