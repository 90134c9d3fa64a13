#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

constexpr std::uint64_t most_array_bytes = std::numeric_limits<std::int32_t>::max();

/// Returns the alignment of a record's field in bytes.
std::uint32_t alignment_of(const Type& type) {
    const Type& form = plain(innermost(type));
    return form.kind == Type::Kind::basic ? std::min(bytes_of(form.basic), std::uint32_t{4}) : 4;
}

} // namespace

const Type* Checker::type_of(TypeText& text, Open open) {
    const auto known = resolved_.find(&text);
    if (known != resolved_.end())
        return known->second;
    const Type* const type = with_dimensions(text, innermost_type(text), open);
    resolved_[&text] = type;
    return type;
}

const Type* Checker::named_type(const TypeText& text, const std::string& name) {
    if (program_.is_configuration && routines_.empty() && !names_.find(name))
        for (const Type::Kind kind : {Type::Kind::node, Type::Kind::arc, Type::Kind::edge})
            if (name == name_of(Type{.kind = kind}))
                return types_.hardware(kind);
    const Declaration* const found = find(name, text.at);
    if (!found)
        return mistaken();
    if (std::holds_alternative<DataType>(found->form))
        return found->type ? found->type : mistaken();
    const bool is_protocol = std::holds_alternative<Protocol>(found->form);
    report(text.at, "\"" + name + "\" is not a type", is_protocol ? "write CHAN OF " + name : "", found);
    return mistaken();
}

const Type* Checker::innermost_type(TypeText& text) {
    if (const auto* simple = std::get_if<Basic>(&text.form))
        return basic(*simple);
    if (auto* channel = std::get_if<TypeText::Channel>(&text.form)) {
        const ProtocolType* const protocol = protocol_of(channel->protocol, text.at);
        return protocol ? types_.channel(protocol) : mistaken();
    }
    if (auto* port = std::get_if<TypeText::Port>(&text.form)) {
        const Type* const of = port->of ? type_of(*port->of, Open::refused) : mistaken();
        return of->kind == Type::Kind::mistaken ? of : types_.port(of);
    }
    if (const auto* named = std::get_if<TypeText::Named>(&text.form))
        return named_type(text, named->name);
    return types_.timer();
}

const Type* Checker::with_dimensions(TypeText& text, const Type* type, Open open) {
    bool is_mistaken = type->kind == Type::Kind::mistaken;
    for (auto each = text.dimensions.rbegin(); each != text.dimensions.rend(); ++each) {
        std::optional<std::uint32_t> count;
        if (*each) {
            count = dimension(**each);
            is_mistaken |= !count;
        } else if (open == Open::refused) {
            report(text.at, "an array of unknown size cannot be declared here",
                   "write its size, such as [10]; [] is for parameters and abbreviations");
            is_mistaken = true;
        }
        if (is_mistaken)
            continue;
        type = types_.array(type, count);
        if (bytes_of(*type) > most_array_bytes) {
            report((*each)->at, "an array of " + std::to_string(bytes_of(*type)) + " bytes is larger than the memory",
                   "");
            is_mistaken = true;
        }
    }
    return is_mistaken ? mistaken() : type;
}

std::optional<std::uint32_t> Checker::dimension(Expression& expression) {
    value_of(expression, basic(Basic::integer), "the size of an array");
    if (expression.type->kind == Type::Kind::mistaken)
        return std::nullopt;
    if (!expression.constant) {
        report(expression.at, "the size of an array must be a constant", "use a VAL that is known at compile time");
        return std::nullopt;
    }
    if (expression.constant->bits <= 0) {
        report(expression.at, "the size of an array is " + std::to_string(expression.constant->bits),
               "an array has at least one element");
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(expression.constant->bits);
}

const ProtocolType* Checker::protocol_of(ProtocolText& text, const Place& place) {
    if (text.any)
        return types_.protocol({.kind = ProtocolType::Kind::any});
    if (text.items.size() == 1 && !text.items[0].count && text.items[0].type) {
        TypeText& single = *text.items[0].type;
        const auto* named = std::get_if<TypeText::Named>(&single.form);
        Declaration* const found = named && single.dimensions.empty() ? find(named->name, single.at) : nullptr;
        if (found && std::holds_alternative<Protocol>(found->form))
            return std::get<Protocol>(found->form).meaning;
        if (named && single.dimensions.empty() && !found)
            return nullptr;
    }
    ProtocolType protocol{.kind = ProtocolType::Kind::sequence, .items = items_of(text.items)};
    if (protocol.items.size() != text.items.size())
        return nullptr;
    if (protocol.items.size() > 1)
        report(place, "a protocol of several items needs a name", "declare it: PROTOCOL P IS ...:");
    return types_.protocol(std::move(protocol));
}

std::optional<ProtocolItem> Checker::item_of(ItemText& text) {
    if (!text.type)
        return std::nullopt;
    ProtocolItem item{type_of(*text.type, text.count ? Open::allowed : Open::refused), nullptr};
    if (text.count)
        item.count = type_of(*text.count, Open::refused);
    if (item.type->kind == Type::Kind::mistaken || (item.count && item.count->kind == Type::Kind::mistaken))
        return std::nullopt;
    if (!is_data(*item.type)) {
        report(text.type->at, "a channel cannot carry " + name_of(*item.type), "");
        return std::nullopt;
    }
    if (item.count && (plain(*item.count).kind != Type::Kind::basic || !is_integer(plain(*item.count).basic))) {
        report(text.count->at, "the count of an array must be an integer, not " + name_of(*item.count), "");
        return std::nullopt;
    }
    return item;
}

std::vector<ProtocolItem> Checker::items_of(std::vector<ItemText>& texts) {
    std::vector<ProtocolItem> items;
    for (ItemText& text : texts) {
        if (const std::optional<ProtocolItem> item = item_of(text))
            items.push_back(*item);
    }
    return items;
}

void Checker::add_tag(ProtocolType& protocol, ProtocolTag tag, const Place& place) {
    const auto same = [&](const ProtocolTag& other) { return other.name == tag.name; };
    if (std::ranges::any_of(protocol.tags, same))
        return report(place, "the tag \"" + tag.name + "\" appears twice in this protocol", "");
    if (protocol.tags.size() > 255)
        return report(place, "a protocol has at most 256 tags", "");
    tag.value = static_cast<std::uint8_t>(protocol.tags.size());
    protocol.tags.push_back(std::move(tag));
}

void Checker::add_tags(ProtocolType& protocol, Protocol& written) {
    for (TagText& tag : written.tags) {
        std::vector<ProtocolItem> items = items_of(tag.items);
        add_tag(protocol, {.name = tag.name, .items = std::move(items)}, tag.at);
    }
}

/// Returns an earlier protocol that has the same name and the same items; if there is none, adds this protocol, and
/// returns it. A program and its libraries may include the same declaration.
const ProtocolType* Checker::shared_protocol(const Declaration& declaration, ProtocolType protocol) {
    const auto same_tag = [](const ProtocolTag& a, const ProtocolTag& b) {
        return a.name == b.name && a.items == b.items;
    };
    const auto same = [&](const ProtocolType* other) {
        return other->declared->name == declaration.name && other->kind == protocol.kind &&
               other->items == protocol.items && std::ranges::equal(other->tags, protocol.tags, same_tag);
    };
    const auto earlier = std::ranges::find_if(named_protocols_, same);
    if (earlier != named_protocols_.end())
        return *earlier;
    protocol.declared = &declaration;
    return named_protocols_.emplace_back(types_.protocol(std::move(protocol)));
}

const Type* Checker::record_type(const Declaration& declaration, DataType& text) {
    std::vector<Field> fields;
    std::map<std::string, Place> places;
    std::uint32_t offset = 0;
    bool all_are_aligned = true;
    for (DataType::FieldText& field : text.fields) {
        const Type* const type = field.type ? type_of(*field.type, Open::refused) : mistaken();
        const auto [earlier, is_new] = places.emplace(field.name, field.at);
        if (!is_new)
            report(field.at, "the field \"" + field.name + "\" appears twice in this record", "",
                   {{"first declared here", program_.location(earlier->second)}});
        if (type->kind != Type::Kind::mistaken && !is_data(*type))
            report(field.at, "a field of a record cannot be " + name_of(*type), "");
        const std::uint32_t multiple = text.is_packed ? 1 : alignment_of(*type);
        offset = (offset + multiple - 1) / multiple * multiple;
        if (const std::uint32_t needed = word_alignment_of(*type); offset % needed != 0) {
            all_are_aligned = false;
            report(
                field.at,
                fmt::format("the field \"{}\" begins at byte {} of the packed record, but {} must begin at a multiple "
                            "of {}",
                            field.name, offset, name_of(*type), needed),
                fmt::format("put a field of {} bytes before it, or the longer fields first", needed - offset % needed));
        }
        fields.push_back({field.name, type, offset});
        const std::uint64_t end = offset + bytes_of(*type);
        if (end > most_array_bytes) {
            report(field.at, "the record is larger than the memory", "");
            break;
        }
        offset = static_cast<std::uint32_t>(end);
    }
    const Type* const record = types_.record(&declaration, std::move(fields));
    if (all_are_aligned)
        require_whole_words(declaration, *record);
    return record;
}

/// Reports a packed record of words whose size is not a whole number of words, because in an array of such records the
/// words would not be aligned.
void Checker::require_whole_words(const Declaration& declaration, const Type& record) {
    const std::uint64_t bytes = bytes_of(record), needed = word_alignment_of(record);
    if (bytes % needed != 0)
        report(declaration.at,
               fmt::format("the packed record \"{}\" has {} bytes, but a record with words must have a multiple of {}",
                           declaration.name, bytes, needed),
               fmt::format("add a field [{}]BYTE at its end", needed - bytes % needed));
}

} // namespace placedpar::occam
