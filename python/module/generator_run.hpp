#pragma once

#include "python/module/operation.hpp"
#include "runtime/alternation.hpp"

#include <list>
#include <memory>
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
    /// Takes a generator, or an operation of the enclosing generator. REQUIRES: the caller holds the lock, in
    /// Interpreter::call().
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
    pybind11::object generator_; ///< null if a single operation is to be done
    pybind11::object where_;     ///< the generator whose line is that of this run
    pybind11::object operation_; ///< of the generator
    Operation* now_ = nullptr;
    pybind11::object result_; ///< of the generator, once it has ended
    std::vector<Guard> guards_;
    std::vector<std::shared_ptr<ChannelEnd>> guarded_; ///< for each guard the end that it guards, or null
    std::size_t chosen_ = 0;
    std::list<GeneratorRun> components_;
    std::string refused_; ///< why the operation failed; "" if it did not
};

} // namespace placedpar::python
