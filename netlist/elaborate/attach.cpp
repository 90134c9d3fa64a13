#include "netlist/elaborate/elaborator.hpp"

#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

constexpr const char* how_to_attach = "a device is connected to a slot of a bus: connect sun.bus[0] to vme.slot[1];";

} // namespace

bool Elaborator::leads_to_bus(const Reference& reference, const Found& found) const {
    return found.category == Category::node && (reference.field == "bus" || reference.field == "slot");
}

void Elaborator::connect_to_bus(const ConnectStatement& form, const Found& a, const Found& b, const Location& at) {
    if (!leads_to_bus(form.a, a) || !leads_to_bus(form.b, b))
        refuse(form.b.at, "a slot of a bus can be connected only to the bus end of a device, such as sun.bus[0]",
               "use a link adapter (C011, C012) between the bus and the link; processes are placed on "
               "workstations and bus masters");
    if (form.a.field == form.b.field)
        refuse(form.b.at,
               form.a.field == "slot" ? "two buses cannot be connected" : "two devices are connected without a bus",
               how_to_attach);
    bool first_is_bus = form.a.field == "slot";
    const auto &bus = first_is_bus ? form.a : form.b, &device = first_is_bus ? form.b : form.a;
    DraftAttachment attachment;
    attachment.bus = bus_end(bus, first_is_bus ? a : b);
    attachment.slot = bus_subscript(bus, 1, draft_.nodes[attachment.bus].kind->medium->slots);
    attachment.node = device_end(device, first_is_bus ? b : a);
    bus_subscript(device, 0, 0);
    auto known = std::ranges::find(draft_.attachments, attachment.node, &DraftAttachment::node);
    if (known != draft_.attachments.end())
        refuse(device.at, fmt::format("\"{}\" is connected to a bus twice", draft_.nodes[attachment.node].name), "",
               {{"first connected here", known->at}});
    count_things(1, at);
    attachment.connection = connection_for(form, at);
    attachment.at = at;
    draft_.attachments.push_back(attachment);
}

std::size_t Elaborator::bus_end(const Reference& reference, const Found& found) {
    auto node = element(reference, found);
    if (!draft_.nodes[node].kind->medium)
        refuse(reference.field_at, fmt::format("{} has no slots", with_article(draft_.nodes[node].type)),
               "a bus has slots: VME vme;");
    return node;
}

std::size_t Elaborator::device_end(const Reference& reference, const Found& found) {
    auto node = element(reference, found);
    const DeviceKind& kind = *draft_.nodes[node].kind;
    if (kind.medium)
        refuse(reference.field_at,
               fmt::format("a {} has only slots: write {}.slot[...]", draft_.nodes[node].type, reference.name),
               how_to_attach);
    if (kind.bus == BusRole::none)
        refuse(reference.field_at,
               fmt::format("{} cannot be connected to a bus", with_article(draft_.nodes[node].type)),
               "only a workstation, a busmaster or a link adapter (C011, C012) can be connected to a bus");
    return node;
}

int Elaborator::bus_subscript(const Reference& reference, int least, int most) {
    auto given = subscripts(reference.field_subscripts);
    std::string range = least == most ? fmt::format("write {}.{}[{}]", reference.name, reference.field, least)
                                      : fmt::format("expected from {} to {}", least, most);
    if (given.size() != 1)
        refuse(reference.field_at,
               fmt::format("wrong number of subscripts: \"{}\" has 1, but the statement gives {}", reference.field,
                           given.size()),
               range);
    if (given[0] < least || given[0] > most)
        refuse(reference.field_subscripts[0]->at,
               fmt::format("the subscript {} is outside of \"{}\"", given[0], reference.field), range);
    return static_cast<int>(given[0]);
}

} // namespace placedpar
