#include "occam/network/multiplexer.hpp"

#include "occam/language/tree.hpp"
#include "occam/network/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>

namespace placedpar::occam {

namespace {

/// Describes a form of the messages of a channel. A variant protocol has a form for each tag; any other protocol has
/// one form.
struct MessageForm {
    std::string tag; ///< empty if the protocol has no tags
    const std::vector<ProtocolItem>* items;
};

std::vector<MessageForm> forms_of(const ProtocolType& protocol) {
    if (protocol.kind != ProtocolType::Kind::variant)
        return {{"", &protocol.items}};
    std::vector<MessageForm> forms;
    for (const ProtocolTag& tag : protocol.tags)
        forms.push_back({tag.name, &tag.items});
    return forms;
}

std::string tag_on_wire(const CarriedChannel& channel, const MessageForm& form) {
    return fmt::format("netlist.message.{}{}{}", channel.number, form.tag.empty() ? "" : ".", form.tag);
}

std::string taken(const CarriedChannel& channel) { return fmt::format("netlist.taken.{}", channel.number); }

/// Writes declarations of the variables for the items of a message: a separate variable for each item of each form.
class MessageVariables {
public:
    MessageVariables(const CarriedChannel& channel, const std::string& prefix) : channel_(channel), prefix_(prefix) {}

    std::string declarations() const {
        std::string text;
        const std::vector<MessageForm> forms = forms_of(*channel_.protocol);
        for (std::size_t f = 0; f < forms.size(); ++f)
            for (std::size_t i = 0; i < forms[f].items->size(); ++i)
                text += declaration((*forms[f].items)[i], name(f, i));
        return text;
    }

    /// Returns the items of a form for an input or output, such as "x; n::a".
    std::string items(std::size_t form) const {
        std::vector<std::string> names;
        const std::vector<ProtocolItem>& items = *forms_of(*channel_.protocol)[form].items;
        for (std::size_t i = 0; i < items.size(); ++i)
            names.push_back(items[i].count ? fmt::format("{0}.count::{0}", name(form, i)) : name(form, i));
        return fmt::format("{}", fmt::join(names, "; "));
    }

    /// Returns the tag and the items after it.
    std::string behind(const std::string& tag, std::size_t form) const {
        const std::string all = items(form);
        return tag + (tag.empty() || all.empty() ? "" : "; ") + all;
    }

private:
    std::string name(std::size_t form, std::size_t item) const {
        return fmt::format("netlist.{}.{}.{}.{}", prefix_, channel_.number, form, item);
    }

    std::string declaration(const ProtocolItem& item, const std::string& variable) const {
        if (!item.count)
            return fmt::format("{} {}:\n", name_of(*item.type), variable);
        return fmt::format("{0} {1}.count:\n[{2}]{3} {1}:\n", name_of(*item.count), variable,
                           longest_array(channel_, item), name_of(*item.type->element));
    }

    const CarriedChannel& channel_;
    std::string prefix_;
};

/// Writes the processes at one end of a shared wire, which carries several channels in one of its directions.
class SharedWireText {
public:
    explicit SharedWireText(const SharedWire& wire) : w_(wire), at_(std::to_string(wire.link)) {}

    CarrierText write() {
        text_.protocols = protocol("out", w_.leaving, w_.arriving) + protocol("in", w_.arriving, w_.leaving);
        declare_wire();
        std::string sends, inputs;
        for (const CarriedChannel& each : w_.leaving)
            add_leaving(each, sends, inputs);
        for (const CarriedChannel& each : w_.arriving)
            add_arriving(each, sends, inputs);
        add("demux", "WHILE TRUE\n  netlist.from.link." + at_ + " ? CASE\n" + indented(inputs, 4));
        add("mux", fmt::format("WHILE TRUE\n"
                               "  SEQ\n"
                               "    IF\n"
                               "      netlist.first.{0} = netlist.next.{0}\n"
                               "        BYTE woken:\n"
                               "        SEQ\n"
                               "          netlist.rests.{0} := TRUE\n"
                               "          netlist.wake.{0} ? woken\n"
                               "      TRUE\n"
                               "        SKIP\n"
                               "    CASE netlist.queue.{0}[netlist.first.{0}]\n"
                               "{1}"
                               "    netlist.first.{0} := (netlist.first.{0} + 1) /\\ {2}\n",
                               at_, indented(sends, 6), room() - 1));
        return std::move(text_);
    }

private:
    void add(const std::string& what, std::string text, const CarriedChannel* of = nullptr) {
        text_.components.push_back(
            {fmt::format("{} of link[{}]{}{}", what, at_, of ? ", " : "", of ? of->name : ""), std::move(text), true});
    }

    /// Returns the number of entries for which the queue has room. At most one entry for each channel waits, in
    /// addition to the entry that is being sent.
    std::size_t room() const { return std::bit_ceil(w_.leaving.size() + w_.arriving.size() + 2); }

    std::string protocol(const char* direction, const std::vector<CarriedChannel>& with,
                         const std::vector<CarriedChannel>& against) const {
        std::string text = fmt::format("PROTOCOL netlist.{}.{}\n  CASE\n", direction, at_);
        for (const CarriedChannel& each : with)
            for (const MessageForm& form : forms_of(*each.protocol))
                text += fmt::format("    {}{}{}\n", tag_on_wire(each, form), form.items->empty() ? "" : "; ",
                                    text_of_items(*form.items));
        for (const CarriedChannel& each : against)
            text += fmt::format("    {}\n", taken(each));
        return text + ":\n";
    }

    void declare_wire() {
        text_.declarations += fmt::format("CHAN OF netlist.out.{0} netlist.to.link.{0}:\n"
                                          "PLACE netlist.to.link.{0} AT {0}:\n"
                                          "CHAN OF netlist.in.{0} netlist.from.link.{0}:\n"
                                          "PLACE netlist.from.link.{0} AT {1}:\n"
                                          "[{2}]INT netlist.queue.{0}:\n"
                                          "INITIAL INT netlist.first.{0} IS 0:\n"
                                          "INITIAL INT netlist.next.{0} IS 0:\n"
                                          "INITIAL BOOL netlist.rests.{0} IS FALSE:\n"
                                          "CHAN OF BYTE netlist.wake.{0}:\n",
                                          at_, w_.link + first_input_link, room());
    }

    /// Returns statements that put an entry into the queue. They also wake the process that empties the queue, if it
    /// waits.
    std::string enqueue(const std::string& entry) const {
        return fmt::format("netlist.queue.{0}[netlist.next.{0}] := {1}\n"
                           "netlist.next.{0} := (netlist.next.{0} + 1) /\\ {2}\n"
                           "IF\n"
                           "  netlist.rests.{0}\n"
                           "    SEQ\n"
                           "      netlist.rests.{0} := FALSE\n"
                           "      netlist.wake.{0} ! 0(BYTE)\n"
                           "  TRUE\n"
                           "    SKIP\n",
                           at_, entry, room() - 1);
    }

    void add_leaving(const CarriedChannel& channel, std::string& sends, std::string& inputs) {
        const MessageVariables variables(channel, "sent");
        const std::string name = fmt::format("netlist.was.taken.{}", channel.number);
        text_.declarations += fmt::format("CHAN OF BYTE {}:\n{}", name, variables.declarations());
        inputs += fmt::format("{}\n  {} ! 0(BYTE)\n", taken(channel), name);
        const std::vector<MessageForm> forms = forms_of(*channel.protocol);
        const bool has_tags = !forms.front().tag.empty();
        std::string input =
            fmt::format("{} ? {}\n", name_of_channel(channel.number), has_tags ? "CASE" : variables.items(0));
        const std::size_t first = entries_;
        for (std::size_t i = 0; i < forms.size(); ++i, ++entries_) {
            if (has_tags)
                input += fmt::format("  {}\n    form := {}\n", variables.behind(forms[i].tag, i), entries_);
            sends += fmt::format("{}\n  netlist.to.link.{} ! {}\n", entries_, at_,
                                 variables.behind(tag_on_wire(channel, forms[i]), i));
        }
        add("mux",
            fmt::format("{}BYTE taken:\nWHILE TRUE\n  SEQ\n{}    {} ? taken\n", has_tags ? "INT form:\n" : "",
                        indented(input + enqueue(has_tags ? "form" : std::to_string(first)), 4), name),
            &channel);
    }

    void add_arriving(const CarriedChannel& channel, std::string& sends, std::string& inputs) {
        const MessageVariables variables(channel, "came");
        const std::string name = fmt::format("netlist.has.come.{}", channel.number);
        text_.declarations += fmt::format("CHAN OF BYTE {}:\n{}", name, variables.declarations());
        const std::vector<MessageForm> forms = forms_of(*channel.protocol);
        std::string outputs;
        for (std::size_t i = 0; i < forms.size(); ++i) {
            inputs +=
                fmt::format("{}\n  {} ! {}(BYTE)\n", variables.behind(tag_on_wire(channel, forms[i]), i), name, i);
            const std::string output =
                fmt::format("{} ! {}\n", name_of_channel(channel.number), variables.behind(forms[i].tag, i));
            outputs += forms.size() == 1 ? output : fmt::format("  {}(BYTE)\n    {}", i, output);
        }
        if (forms.size() > 1)
            outputs = "CASE form\n" + outputs;
        sends += fmt::format("{}\n  netlist.to.link.{} ! {}\n", entries_, at_, taken(channel));
        add("demux",
            fmt::format("BYTE form:\nWHILE TRUE\n  SEQ\n    {} ? form\n{}", name,
                        indented(outputs + enqueue(std::to_string(entries_)), 4)),
            &channel);
        ++entries_;
    }

    const SharedWire& w_;
    std::string at_; ///< number of the link
    CarrierText text_;
    std::size_t entries_ = 0; ///< number of different entries that the text can put into the queue so far
};

} // namespace

namespace {

/// Returns whether a program may give an array another number of elements, by RETYPES or RESHAPES.
bool sees_arrays_otherwise(const Program& program) {
    return std::ranges::any_of(program.files, [](const std::shared_ptr<const SourceFile>& file) {
        return !file->path().starts_with('<') && (file->text().find("RETYPES") != std::string::npos ||
                                                  file->text().find("RESHAPES") != std::string::npos);
    });
}

/// Returns whether the size of values of the type is known.
bool has_size(const Type& type) {
    if (type.kind == Type::Kind::array)
        return type.count && has_size(*type.element);
    return type.kind == Type::Kind::basic || type.kind == Type::Kind::record ||
           (type.kind == Type::Kind::derived && has_size(*type.element));
}

/// Returns the greatest value of a count of this type.
std::uint64_t most_of(const Type& count) {
    return count.kind == Type::Kind::derived ? most_of(*count.element)
           : count.is(Basic::byte)           ? 255
           : count.is(Basic::int16)          ? 32767
                                             : 2147483647;
}

} // namespace

std::uint64_t longest_array(const CarriedChannel& channel, const ProtocolItem& item) {
    const Type& element = *item.type->element;
    const bool any_type = sees_arrays_otherwise(*channel.program);
    std::uint64_t longest = element.is(Basic::byte) ? std::max<std::uint64_t>(channel.longest_text, 1) : 1;
    for (const Type& each : channel.program->types.all()) {
        const bool is_array = each.kind == Type::Kind::array && has_size(each);
        if (is_array && each.element == &element)
            longest = std::max<std::uint64_t>(longest, *each.count);
        else if (any_type && (is_array || each.kind == Type::Kind::record))
            longest = std::max(longest, bytes_of(each) / bytes_of(element));
    }
    return std::min(longest, most_of(*item.count));
}

std::size_t count_of_messages(const std::vector<CarriedChannel>& with, const std::vector<CarriedChannel>& against) {
    std::size_t count = against.size();
    for (const CarriedChannel& each : with)
        count += forms_of(*each.protocol).size();
    return count;
}

std::string indented(const std::string& text, std::size_t by) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at) + 1;
        result += std::string(by, ' ') + text.substr(at, end - at);
        at = end;
    }
    return result;
}

std::string name_of_channel(std::size_t number) { return fmt::format("netlist.channel.{}", number); }

CarrierText text_of_shared_wire(const SharedWire& wire) { return SharedWireText(wire).write(); }

Component text_of_relay(const CarriedChannel& channel, const std::string& in, const std::string& out) {
    const MessageVariables variables(channel, "passed");
    const std::vector<MessageForm> forms = forms_of(*channel.protocol);
    std::string text = fmt::format("{}WHILE TRUE\n", variables.declarations());
    if (forms.front().tag.empty())
        text += fmt::format("  SEQ\n    {0} ? {2}\n    {1} ! {2}\n", in, out, variables.items(0));
    else
        text += fmt::format("  {} ? CASE\n", in);
    for (std::size_t i = 0; i < forms.size(); ++i)
        if (!forms[i].tag.empty())
            text += fmt::format("    {0}\n      {1} ! {0}\n", variables.behind(forms[i].tag, i), out);
    return {"relay of " + channel.name, std::move(text), true};
}

} // namespace placedpar::occam
