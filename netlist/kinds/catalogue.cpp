#include "netlist/kinds/catalogue.hpp"

#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/file_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar {

namespace {

[[noreturn]] void refuse_second(std::string_view what, std::string_view name) {
    throw std::logic_error(fmt::format("the {} \"{}\" is in the catalogue already; use another name", what, name));
}

} // namespace

Catalogue::Catalogue() {
    for (auto device : known_devices)
        add_device(device());
}

void Catalogue::add(ProcessKind kind) {
    auto name = kind.name;
    if (!kinds_.emplace(name, std::move(kind)).second)
        refuse_second("process kind", name);
}

const ProcessKind* Catalogue::find(std::string_view name) const {
    if (auto found = kinds_.find(name); found != kinds_.end())
        return &found->second;
    return files_ ? files_->find(name) : nullptr;
}

std::vector<std::string> Catalogue::kind_names() const {
    std::vector<std::string> names;
    for (const auto& [name, entry] : kinds_)
        names.push_back(name);
    return names;
}

void Catalogue::add_device(DeviceKind kind) {
    auto shared = std::make_shared<const DeviceKind>(std::move(kind));
    for (const auto& attribute : shared->attributes)
        if (!attribute.value.default_value)
            throw std::logic_error(
                fmt::format("attribute \"{}\" of \"{}\" has no default", attribute.value.name, shared->name));
    if (!devices_.emplace(shared->name, shared).second)
        refuse_second("device kind", shared->name);
    for (const auto& model : shared->models)
        if (!node_types_.emplace(model.name, node_type(shared, model)).second)
            refuse_second("node type", model.name);
}

} // namespace placedpar
