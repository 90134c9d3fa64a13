#include "python/module/generator_run.hpp"

#include "runtime/kernel.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <stdexcept>
#include <utility>

namespace placedpar::python {

namespace py = pybind11;
using Kind = Operation::Kind;

namespace {

/// Returns the place at which a generator waits, such as "relay.py:12". If the generator waits at a `yield from`,
/// returns the place in the innermost generator.
std::string place_of(py::object generator) {
    while (py::hasattr(generator, "gi_yieldfrom") && py::hasattr(generator.attr("gi_yieldfrom"), "gi_frame"))
        generator = generator.attr("gi_yieldfrom");
    if (!py::hasattr(generator, "gi_frame") || generator.attr("gi_frame").is_none())
        return "";
    const py::object frame = generator.attr("gi_frame");
    const auto file = frame.attr("f_code").attr("co_filename").cast<std::string>();
    return file.substr(file.find_last_of('/') + 1) + ":" + std::to_string(frame.attr("f_lineno").cast<int>());
}

} // namespace

GeneratorRun::~GeneratorRun() {
    // If the generator refuses to be closed, Python reports the refusal. The run continues.
    python_.call([&] {
        components_.clear();
        generator_ = where_ = operation_ = result_ = py::object();
    });
}

/// Notes where the generator waits in its program. REQUIRES: called by the process of this run.
void GeneratorRun::note_place() const {
    if (!now_)
        return;
    try {
        python_.call([&] {
            if (const std::string place = place_of(where_); !place.empty())
                python_.places.try_emplace(Kernel::current()->running().path(), place);
        });
    } catch (const std::exception&) {
        // If this fails, the report of a deadlock has the place in the C++ library instead of the place in Python.
    }
}

void GeneratorRun::start(py::object component, const py::object& enclosing) {
    if (PyGen_CheckExact(component.ptr())) {
        generator_ = where_ = std::move(component);
        return;
    }
    where_ = enclosing;
    if (!py::isinstance<Operation>(component))
        throw py::type_error("a component of pp.par must be a generator or an operation");
    operation_ = std::move(component);
    now_ = operation_.cast<Operation*>();
    prepare();
}

void GeneratorRun::finish() {
    // Notes the generator's place also if the run ends while this process waits.
    const std::shared_ptr<const void> leaving(nullptr, [this](const void*) { note_place(); });
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
    if (!take(sent, yielded))
        prepare_or_fail();
}

void GeneratorRun::prepare_or_fail() {
    try {
        prepare();
    } catch (const py::builtin_exception& error) {
        fail(py::reinterpret_borrow<py::object>(PyExc_TypeError)(error.what()));
    } catch (const UserError& error) {
        fail(error_named("Error")(error.what()));
    }
}

/// Throws the error at the generator's `yield`. If the generator handles the error, the run continues with the next
/// operation that it yields.
void GeneratorRun::fail(const py::object& error) {
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

/// Stores what the generator yielded or returned. Returns whether the generator has ended.
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

/// Copies the operation's arguments from Python, while this thread holds Python's global lock.
void GeneratorRun::prepare() {
    if (!now_)
        throw py::type_error(py::str("a body yields operations, such as self.inp.input() or pp.compute(100), not {!r}")
                                 .format(operation_)
                                 .cast<std::string>());
    if (now_->end)
        now_->end->require_attached();
    switch (now_->kind) {
    case Kind::output: return now_->end->take(now_->value);
    case Kind::alt: return prepare_guards();
    case Kind::par: return begin_components();
    case Kind::skip:
    case Kind::never: throw py::type_error("pp.skip and pp.when are guards of pp.alt, not operations");
    default: break;
    }
}

void GeneratorRun::prepare_guards() {
    guards_.clear();
    guarded_.clear();
    for (const py::handle each : now_->value) {
        std::shared_ptr<ChannelEnd> end;
        if (py::isinstance<ChannelEnd>(each))
            end = each.cast<std::shared_ptr<ChannelEnd>>();
        else if (py::isinstance<Operation>(each) && each.cast<Operation*>()->kind == Kind::input)
            end = each.cast<Operation*>()->end;
        if (end)
            end->require(Direction::input);
        guards_.push_back(end ? Guard{Guard::input, &end->channel()} : guard_of(each));
        guarded_.push_back(std::move(end));
    }
}

/// Returns the guard of an operation other than an input.
Guard GeneratorRun::guard_of(py::handle guard) const {
    if (!py::isinstance<Operation>(guard))
        throw py::type_error("a guard of pp.alt must be an input end, pp.wait, pp.until, pp.after, pp.skip or pp.when");
    const auto& operation = *guard.cast<Operation*>();
    switch (operation.kind) {
    case Kind::wait: return {Guard::timeout, nullptr, later(now(), Time{operation.number})};
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
        components_.emplace_back().start(py::reinterpret_borrow<py::object>(each), where_);
}

/// Performs the operation without Python's global lock. An error of the library is later thrown into the generator.
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
        case Kind::never: return; // refused by prepare()
        }
    } catch (const std::exception& error) {
        refused_ = error.what();
    }
}

void GeneratorRun::alternate() {
    chosen_ = select(guards_);
    if (const auto& end = guarded_[chosen_])
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
    if (python_.clock)
        python_.clock->picoseconds = now().count();
    if (!generator_) {
        if (!refused_.empty())
            throw std::runtime_error(refused_);
        result_ = result_of_operation();
        now_ = nullptr;
    } else if (!refused_.empty()) {
        fail(error_named("Error")(std::exchange(refused_, "")));
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
