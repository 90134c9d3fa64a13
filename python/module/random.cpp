#include "python/module/random.hpp"
#include "python/module/module.hpp"

#include "python/module/given.hpp"
#include "text/user_error.hpp"

namespace placedpar::python {

RandomStream& PythonRandom::stream() const {
    if (!random_)
        throw UserError("random can be used only during the call of the policy that received it");
    return *random_;
}

void add_random(pybind11::module_& module) {
    pybind11::class_<PythonRandom, std::shared_ptr<PythonRandom>>(module, "RandomStream")
        .def(pybind11::init([](Given<std::uint64_t, "seed"> seed, const Given<std::string, "name">& name) {
            return std::make_shared<PythonRandom>(RandomStream(seed, name.value));
        }))
        .def(pybind11::init(refusal<std::shared_ptr<PythonRandom>>("RandomStream(seed, name)")))
        .def("uniform", [](const PythonRandom& it) { return it.stream().uniform(); })
        .def("uniform", refusal("uniform()"))
        .def("below", [](const PythonRandom& it, Given<std::uint32_t, "n"> n) { return it.stream().below(n); })
        .def("below", refusal("below(n)"))
        .def("normal", [](const PythonRandom& it) { return it.stream().normal(); })
        .def("normal", refusal("normal()"))
        .def("chance", [](const PythonRandom& it, Given<double, "probability"> p) { return it.stream().chance(p); })
        .def("chance", refusal("chance(probability)"));
}

} // namespace placedpar::python
