#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"
#include "text/nearest.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

constexpr const char* how_direction(Direction direction) {
    return direction == Direction::output ? "for output" : "for input";
}

} // namespace

void Checker::communicates(const Place& place, const std::string& what) {
    if (routines_.empty())
        return;
    if (routines_.back().is_function)
        report(place, "a function cannot have " + what, "use a PROC");
    else if (routines_.back().communicates.empty())
        routines_.back().communicates = what;
}

const Type* Checker::channel(Expression& expression, const char* action) {
    const Type* const type = check(expression);
    const Type::Kind kind = type->kind;
    if (kind == Type::Kind::channel || kind == Type::Kind::port || kind == Type::Kind::timer ||
        kind == Type::Kind::mistaken)
        return type;
    const bool is_array = kind == Type::Kind::array && !is_data(*type);
    report(expression.at, std::string(action) + " needs a channel, not " + name_of(*type),
           is_array ? "choose a channel by a subscript" : "");
    return expression.type = mistaken();
}

void Checker::mark_direction(const Declaration& declaration, Direction direction, const Place& place) {
    // The checker may change the tree. A NameUse refers to a const declaration only because other code must not change
    // it.
    auto& own = const_cast<Declaration&>(declaration);
    const bool is_directed = own.direction != Direction::unused;
    const auto* abbreviation = std::get_if<Abbreviation>(&own.form);
    const bool is_channel = own.type && innermost(*own.type).kind == Type::Kind::channel;
    const bool is_limited = is_channel && (abbreviation ? abbreviation->written_output.has_value()
                                                        : std::holds_alternative<Parameter>(own.form));
    if (!is_directed)
        own.direction = direction;
    const Place first = directed_at_.emplace(&declaration, is_directed ? own.at : place).first->second;
    if (!is_directed || own.direction == direction || !is_limited)
        return;
    if (!is_first(&declaration, "direction"))
        return;
    report(place,
           "the channel \"" + own.name + "\" is used " + how_direction(direction) + " here, and " +
               how_direction(own.direction) + " elsewhere",
           "use two channels: a parameter has one direction",
           {{std::string("used ") + how_direction(own.direction) + " here", program_.location(first)}});
}

void Checker::use_channel(const Expression& expression, Direction direction) {
    for (const Declaration* each = root_of(expression); each; each = named_by(*each))
        mark_direction(*each, direction, expression.at);
}

bool Checker::has_items(const Place& place, std::size_t given, std::size_t wanted) {
    if (given == wanted)
        return true;
    report(place,
           "wrong number of items of the protocol: expected " + std::to_string(wanted) + ", found " +
               std::to_string(given),
           "");
    return false;
}

/// Checks the types of an item, and that it is a counted array if and only if the protocol has one here. Returns false
/// if only one of them is a counted array.
bool Checker::has_form(Item& item, const ProtocolItem& wanted, Direction direction) {
    const bool inputs = direction == Direction::input;
    if (!wanted.count != !item.counted_array) {
        report(item.value.at,
               wanted.count
                   ? "the protocol has a counted array here: " + name_of(*wanted.count) + "::" + name_of(*wanted.type)
                   : "the protocol has a single item here, not a counted array: " + name_of(*wanted.type),
               !wanted.count ? ""
               : inputs      ? "write the variable of the count, :: and the array"
                             : "write the count, :: and the array");
        return false;
    }
    if (!item.counted_array) {
        agrees(item.value, wanted.type, "this item of the protocol",
               inputs ? "input to a variable of type " + name_of(*wanted.type) : "");
        return true;
    }
    agrees(item.value, wanted.count, "the count");
    agrees(*item.counted_array, wanted.type, "the counted array");
    return true;
}

void Checker::input_item(Item& item, const ProtocolItem* wanted) {
    const Type* const type = variable(item.value, "input to");
    if (item.counted_array)
        variable(*item.counted_array, "input to");
    if (!wanted) {
        const Type& form = plain(*type);
        if (item.counted_array && form.kind != Type::Kind::mistaken &&
            (form.kind != Type::Kind::basic || !is_integer(form.basic)))
            report(item.value.at, "the count of an array must be an integer, not " + name_of(*type), "");
        return;
    }
    has_form(item, *wanted, Direction::input);
}

void Checker::input_items(const Place& place, std::vector<Item>& items, const std::vector<ProtocolItem>& wanted,
                          std::size_t first) {
    const bool is_complete = has_items(place, items.size() - first, wanted.size());
    for (std::size_t i = first; i < items.size(); ++i)
        input_item(items[i], is_complete ? &wanted[i - first] : nullptr);
}

void Checker::input(const Place& place, Input& input, bool is_guard) {
    communicates(place, "an input");
    const Type* const type = channel(input.channel, "?");
    use_channel(input.channel, Direction::input);
    if (type->kind == Type::Kind::port && is_guard)
        report(place, "a port cannot be a guard", "");
    if (type->kind == Type::Kind::timer || type->kind == Type::Kind::port) {
        const ProtocolItem item{type->kind == Type::Kind::timer ? basic(Basic::integer) : type->element, nullptr};
        return input_items(place, input.items, {item}, 0);
    }
    const ProtocolType* const protocol = type->protocol;
    if (protocol && protocol->kind == ProtocolType::Kind::variant)
        report(place,
               "a simple input cannot read the variant protocol " +
                   (protocol->declared ? protocol->declared->name : std::string()),
               "write ? CASE and its tags");
    if (protocol && protocol->kind == ProtocolType::Kind::sequence)
        return input_items(place, input.items, protocol->items, 0);
    for (Item& item : input.items)
        input_item(item, nullptr);
}

void Checker::form_of(Process& process, Input& simple) { input(process.at, simple, false); }

void Checker::delay(const Place& place, Delay& delay) {
    communicates(place, "an input");
    const Type* const type = check(delay.timer);
    if (type->kind != Type::Kind::timer && type->kind != Type::Kind::mistaken)
        report(delay.timer.at, "AFTER needs a timer, not " + name_of(*type), "");
    value_of(delay.time, basic(Basic::integer), "the time");
}

void Checker::form_of(Process& process, Delay& after) { delay(process.at, after); }

const ProtocolTag* Checker::tag_of(const ProtocolType& protocol, const std::string& name, const Place& place) {
    const auto found = std::ranges::find(protocol.tags, name, &ProtocolTag::name);
    if (found != protocol.tags.end())
        return &*found;
    if (!is_first(protocol.declared, name))
        return nullptr;
    std::vector<std::string> names;
    for (const ProtocolTag& tag : protocol.tags)
        names.push_back(tag.name);
    report(place, unknown_name("tag", name, names, "the protocol has no such tag"), "", protocol.declared);
    return nullptr;
}

void Checker::check_variant(Variant& variant, const ProtocolType& protocol) {
    const std::size_t mark = names_.mark();
    declare(variant.declarations);
    const ProtocolTag* const tag = tag_of(protocol, variant.tag, variant.at);
    if (tag) {
        variant.tag_value = tag->value;
        input_items(variant.at, variant.items, tag->items, 0);
    } else {
        for (Item& item : variant.items)
            input_item(item, nullptr);
    }
    if (variant.process)
        check(*variant.process);
    names_.leave(mark);
}

void Checker::variant_input(VariantInput& variants) {
    communicates(variants.channel.at, "an input");
    const Type* const type = channel(variants.channel, "? CASE");
    use_channel(variants.channel, Direction::input);
    if (!type->protocol || type->protocol->kind != ProtocolType::Kind::variant) {
        if (type->kind != Type::Kind::mistaken)
            report(variants.channel.at, "? CASE needs a channel of a variant protocol, not " + name_of(*type),
                   "write ? and the items");
        return;
    }
    std::set<std::string> tags;
    for (Variant& variant : variants.variants) {
        if (!tags.insert(variant.tag).second)
            report(variant.at, "the tag \"" + variant.tag + "\" is used twice in this input", "");
        check_variant(variant, *type->protocol);
    }
}

void Checker::form_of(Process&, VariantInput& variants) { variant_input(variants); }

void Checker::output_item(Item& item, const ProtocolItem* wanted) {
    value(item.value);
    if (item.counted_array)
        value(*item.counted_array);
    if (!wanted)
        return;
    if (!has_form(item, *wanted, Direction::output) || !item.counted_array)
        return;
    const Type& array = plain(*item.counted_array->type);
    if (item.value.constant && array.count &&
        (item.value.constant->bits < 0 || item.value.constant->bits > *array.count))
        report(item.value.at,
               "the count " + std::to_string(item.value.constant->bits) + " does not fit an array of " +
                   std::to_string(*array.count) + " elements",
               "");
}

void Checker::output_items(const Place& place, std::vector<Item>& items, const std::vector<ProtocolItem>& wanted,
                           std::size_t first) {
    const bool is_complete = has_items(place, items.size() - first, wanted.size());
    for (std::size_t i = first; i < items.size(); ++i)
        output_item(items[i], is_complete ? &wanted[i - first] : nullptr);
}

void Checker::output_tag(Output& output, const Place& place, const ProtocolType& protocol) {
    Item& first = output.items.front();
    auto* use = std::get_if<NameUse>(&first.value.form);
    const ProtocolTag* tag = nullptr;
    if (use && !first.counted_array)
        tag = tag_of(protocol, use->name, first.value.at);
    else
        report(first.value.at,
               "the first item must be a tag of the protocol " +
                   (protocol.declared ? protocol.declared->name : std::string()),
               "");
    if (!tag) {
        for (std::size_t i = 1; i < output.items.size(); ++i)
            output_item(output.items[i], nullptr);
        return;
    }
    output.tag_value = tag->value;
    first.value.type = basic(Basic::byte);
    first.value.constant = Constant{tag->value, nullptr};
    output_items(place, output.items, tag->items, 1);
}

void Checker::form_of(Process& process, Output& output) {
    communicates(process.at, "an output");
    const Type* const type = channel(output.channel, "!");
    if (type->kind == Type::Kind::timer)
        report(output.channel.at, "a timer cannot be output to", "");
    else
        use_channel(output.channel, Direction::output);
    if (type->kind == Type::Kind::port)
        return output_items(process.at, output.items, {{type->element, nullptr}}, 0);
    const ProtocolType* const protocol = type->protocol;
    if (protocol && protocol->kind == ProtocolType::Kind::variant)
        return output_tag(output, process.at, *protocol);
    if (protocol && protocol->kind == ProtocolType::Kind::sequence)
        return output_items(process.at, output.items, protocol->items, 0);
    for (Item& item : output.items)
        output_item(item, nullptr);
}

} // namespace placedpar::occam
