#pragma once

#include "runtime/random.hpp"

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

namespace placedpar::python {

/// A random stream of Python, its own or one that is lent by the library. Python may keep it for longer than it is
/// lent.
class PythonRandom {
public:
    explicit PythonRandom(const RandomStream& own) : own_(own), random_(&*own_) {}
    explicit PythonRandom(RandomStream* lent) : random_(lent) {}
    PythonRandom(const PythonRandom&) = delete;
    PythonRandom& operator=(const PythonRandom&) = delete;
    /// Throws UserError after end().
    RandomStream& stream() const;
    void end() { random_ = nullptr; }

private:
    std::optional<RandomStream> own_;
    RandomStream* random_;
};

/// Lends a random stream while this object exists.
class Loan {
public:
    explicit Loan(RandomStream& random) : lent_(std::make_shared<PythonRandom>(&random)) {}
    ~Loan() { lent_->end(); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    pybind11::object object() const { return pybind11::cast(lent_); }

private:
    std::shared_ptr<PythonRandom> lent_;
};

/// Declares random streams in the module.
void add_random(pybind11::module_&);

} // namespace placedpar::python
