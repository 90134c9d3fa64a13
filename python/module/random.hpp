#pragma once

#include "runtime/random.hpp"

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

namespace placedpar::python {

/// A random stream for Python: a new stream, or a stream that the library lends during a call. Python may keep a
/// reference after the call.
class PythonRandom {
public:
    explicit PythonRandom(const RandomStream& own) : own_(own), random_(&*own_) {}
    explicit PythonRandom(RandomStream* lent) : random_(lent) {}
    PythonRandom(const PythonRandom&) = delete;
    PythonRandom& operator=(const PythonRandom&) = delete;
    /// Throws UserError if the stream was lent and the loan has ended.
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

} // namespace placedpar::python
