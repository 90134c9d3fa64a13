#include "python/module/generator_run.hpp"

#include "runtime/kernel.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"

#include <stdexcept>
#include <utility>

namespace placedpar::python {

namespace py = pybind11;
using Kind = Operation::Kind;

namespace {

/// Returns the place at which a generator waits, "relay.py:12": that of the innermost generator (`yield from`).
std::string place_of(py::object generator) {
    while (py::hasattr(generator, "gi_yieldfrom") && py::hasattr(generator.attr("gi_yieldfrom"), "gi_frame"))
        generator = generator.attr("gi_yieldfrom");
    if (!py::hasattr(generator, "gi_frame") || generator.attr("gi_frame").is_none())
        return "";
    const py::object frame = generator.attr("gi_frame");
    const auto file = frame.attr("f_code").attr("co_filename").cast<std::string>();
    return file.substr(file.find_last_of('/') + 1) + ":" + py::str(frame.attr("f_lineno")).cast<std::string>();
}

} // namespace

GeneratorRun::~GeneratorRun() {
    const bool waits = now_ && !result_;
    try {
        python_.call([&] {
            if (generator_ && waits)
                python_.places.try_emplace(Kernel::current()->running().path(), place_of(generator_));
            components_.clear();
            generator_ = operation_ = result_ = py::object();
        });
    } catch (const std::exception&) {
        // A generator that refuses to be closed is reported by Python, and does not affect the run.
    }
}

void GeneratorRun::start(py::object component) {
    if (PyGen_CheckExact(component.ptr())) {
        generator_ = std::move(component);
        return;
    }
    if (!py::isinstance<Operation>(component))
        throw py::type_error("a component of pp.par is a generator or an operation");
    operation_ = std::move(component);
    now_ = operation_.cast<Operation*>();
    prepare();
}

void GeneratorRun::finish() {
    if (generator_)
        python_.call([&] { step(py::none()); });
    while (now_) {
        carry_out();
        python_.call([&] { answer(); });
    }
}

/// Continues the generator until it yields the next operation or ends.
void GeneratorRun::step(py::object answer) {
    PyObject* yielded = nullptr;
    const PySendResult sent = PyIter_Send(generator_.ptr(), answer.ptr(), &yielded);
    if (take(sent, yielded))
        return;
    try {
        prepare();
    } catch (const py::builtin_exception& error) {
        fail(error.what());
    }
}

/// Throws a TypeError at the generator's `yield`. A generator that handles it goes on with what it yields then.
void GeneratorRun::fail(const std::string& why) {
    const py::object error = py::reinterpret_borrow<py::object>(PyExc_TypeError)(why);
    try {
        py::object yielded = generator_.attr("throw")(error);
        if (!take(PYGEN_NEXT, yielded.release().ptr()))
            prepare();
    } catch (py::error_already_set& thrown) {
        now_ = nullptr;
        if (!thrown.matches(PyExc_StopIteration))
            throw;
        result_ = thrown.value().attr("value");
    }
}

/// Takes what the generator yielded or returned. Returns whether it has ended.
bool GeneratorRun::take(PySendResult sent, PyObject* yielded) {
    now_ = nullptr;
    if (sent == PYGEN_ERROR)
        throw py::error_already_set();
    if (sent == PYGEN_RETURN) {
        result_ = py::reinterpret_steal<py::object>(yielded);
        return true;
    }
    operation_ = py::reinterpret_steal<py::object>(yielded);
    if (py::isinstance<Operation>(operation_))
        now_ = operation_.cast<Operation*>();
    return false;
}

/// Takes from Python what the operation needs.
void GeneratorRun::prepare() {
    if (!now_)
        throw py::type_error(py::str("a body yields operations, such as self.inp.input() or pp.compute(100), not {!r}")
                                 .format(operation_)
                                 .cast<std::string>());
    if (now_->kind == Kind::output)
        now_->end->take(now_->value);
    if (now_->kind == Kind::alt) {
        guards_.clear();
        guarded_.clear();
        for (const py::handle each : now_->value) {
            guards_.push_back(guard_of(each));
            guarded_.push_back(nullptr);
            if (py::isinstance<ChannelEnd>(each))
                guarded_.back() = each.cast<ChannelEnd*>();
            else if (const auto* operation = each.cast<Operation*>(); operation->kind == Kind::input)
                guarded_.back() = operation->end;
        }
    }
    if (now_->kind == Kind::par)
        begin_components();
}

Guard GeneratorRun::guard_of(py::handle guard) const {
    if (py::isinstance<ChannelEnd>(guard))
        return {Guard::input, &guard.cast<ChannelEnd*>()->channel()};
    if (!py::isinstance<Operation>(guard))
        throw py::type_error("a guard of pp.alt is an input end, pp.wait, pp.until, pp.after, pp.skip or pp.when");
    const auto& operation = *guard.cast<Operation*>();
    switch (operation.kind) {
    case Kind::input: return {Guard::input, &operation.end->channel()};
    case Kind::wait: return {Guard::timeout, nullptr, now() + Time{operation.number}};
    case Kind::until: return {Guard::timeout, nullptr, Time{operation.number}};
    case Kind::after:
        return {Guard::timeout, nullptr, Timer().moment_after(static_cast<std::int32_t>(operation.number))};
    case Kind::skip: return {Guard::skip};
    case Kind::never: return {Guard::never};
    default: throw py::type_error("pp.alt cannot wait for this operation: an output or a computation is not a guard");
    }
}

void GeneratorRun::begin_components() {
    components_.clear();
    for (const py::handle each : now_->value)
        components_.emplace_back().start(py::reinterpret_borrow<py::object>(each));
}

/// Does the operation, without the lock. An error of the library is later thrown into the generator.
void GeneratorRun::carry_out() {
    try {
        switch (now_->kind) {
        case Kind::output: return now_->end->output();
        case Kind::input: return now_->end->input();
        case Kind::compute: return compute(Cycles{now_->number}, {.words_outside = now_->words_outside});
        case Kind::wait: return wait_for(Time{now_->number});
        case Kind::until: return wait_until(Time{now_->number});
        case Kind::after: return Timer().wait_after(static_cast<std::int32_t>(now_->number));
        case Kind::alt: return alternate();
        case Kind::par: return run_components();
        case Kind::stop: return stop();
        case Kind::skip:
        case Kind::never: break;
        }
        refused_ = "pp.skip and pp.when are guards of pp.alt, not operations";
    } catch (const std::exception& error) {
        refused_ = error.what();
    }
}

void GeneratorRun::alternate() {
    chosen_ = select(guards_);
    if (ChannelEnd* end = guarded_[chosen_])
        end->input();
}

void GeneratorRun::run_components() {
    std::vector<Component> components;
    for (GeneratorRun& each : components_)
        components.push_back({[&each] { each.finish(); }, own_priority()});
    if (!components.empty())
        run_in_parallel(std::move(components), {});
}

/// Passes the operation's result, or its error, to the generator.
void GeneratorRun::answer() {
    if (!generator_) {
        if (!refused_.empty())
            throw std::runtime_error(refused_);
        result_ = result_of_operation();
        now_ = nullptr;
    } else if (!refused_.empty()) {
        fail(std::exchange(refused_, ""));
    } else {
        step(result_of_operation());
    }
}

py::object GeneratorRun::result_of_operation() {
    if (now_->kind == Kind::input)
        return now_->end->give();
    if (now_->kind == Kind::alt)
        return py::make_tuple(chosen_, guarded_[chosen_] ? guarded_[chosen_]->give() : py::none());
    if (now_->kind != Kind::par)
        return py::none();
    py::list results;
    for (GeneratorRun& each : components_)
        results.append(each.result_);
    components_.clear();
    return results;
}

} // namespace placedpar::python
