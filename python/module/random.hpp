#pragma once

#include "runtime/random.hpp"

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

namespace placedpar::python {

/// A random stream for Python. The stream is new, or the library lends it for the time of a call, for example to a
/// policy of a search. Python may keep a reference after the call; stream() then throws.
class PythonRandom {
public:
    explicit PythonRandom(const RandomStream& own) : own_(own), random_(&*own_) {}
    explicit PythonRandom(RandomStream* lent) : random_(lent) {}
    PythonRandom(const PythonRandom&) = delete;
    PythonRandom& operator=(const PythonRandom&) = delete;
    /// Returns the stream. Throws UserError if the stream was lent and the call has ended.
    RandomStream& stream() const;
    void end() { random_ = nullptr; }

private:
    std::optional<RandomStream> own_;
    RandomStream* random_;
};

/// Lends a random stream to Python while this object exists.
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
