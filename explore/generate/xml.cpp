#include "explore/generate/xml.hpp"

#include "explore/generate/graph.hpp"
#include "text/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace placedpar::generate {

namespace {

constexpr std::string_view blank = " \t\r\n";

std::string local_name(std::string_view name) { return std::string(name.substr(name.find(':') + 1)); }

std::string utf8_of(std::uint32_t code) {
    auto byte = [](std::uint32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
    if (code < 0x80)
        return {byte(code)};
    if (code < 0x800)
        return {byte(0xc0 | code >> 6), byte(0x80 | (code & 0x3f))};
    if (code < 0x10000)
        return {byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f))};
    return {byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 0x3f)), byte(0x80 | (code >> 6 & 0x3f)),
            byte(0x80 | (code & 0x3f))};
}

/// Returns the text of an entity such as "amp" or "#38"; nothing if it is not predefined.
std::optional<std::string> entity_text(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, const char*>, 5> predefined{
        {{"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}, {"apos", "'"}}};
    for (const auto& [each, text] : predefined)
        if (each == name)
            return text;
    if (!name.starts_with('#'))
        return std::nullopt;
    const bool hexadecimal = name.starts_with("#x");
    const auto code = parse_number<std::uint32_t>(name.substr(hexadecimal ? 2 : 1), hexadecimal ? 16 : 10);
    const bool allowed = code && *code >= ' ' && *code <= 0x10ffff && (*code < 0xd800 || *code > 0xdfff);
    return allowed || (code && (*code == '\n' || *code == '\t')) ? std::optional(utf8_of(*code)) : std::nullopt;
}

} // namespace

void XmlReader::refuse(const std::string& message, const std::string& hint) const {
    refuse_graph(file_, line_, message, hint);
}

std::string_view XmlReader::take(std::size_t bytes) {
    const std::string_view taken = left_.substr(0, bytes);
    line_ += static_cast<std::size_t>(std::ranges::count(taken, '\n'));
    left_.remove_prefix(taken.size());
    return taken;
}

/// Takes the text up to `end`, and `end` itself, which the result does not include.
std::string_view XmlReader::take_to(std::string_view end, const char* what) {
    const std::size_t found = left_.find(end);
    if (found == left_.npos)
        refuse(fmt::format("{} is not closed", what));
    const std::string_view taken = take(found);
    take(end.size());
    return taken;
}

/// Skips a comment, a processing instruction or a document type. Returns false if none follows.
bool XmlReader::skip_unused() {
    if (left_.starts_with("<!--"))
        take_to("-->", "a comment");
    else if (left_.starts_with("<?"))
        take_to("?>", "a processing instruction");
    else if (left_.starts_with("<!DOCTYPE")) {
        if (take_to(">", "the document type").find('[') != std::string_view::npos)
            refuse("the document type declares entities or elements", "a graph in GraphML needs no declarations");
    } else
        return false;
    return true;
}

XmlPiece XmlReader::next() {
    if (std::exchange(end_follows_, false)) {
        XmlPiece piece{.kind = XmlPiece::Kind::end, .name = open_.back(), .text = "", .line = line_};
        open_.pop_back();
        return piece;
    }
    while (skip_unused()) {
    }
    if (left_.empty() && !open_.empty())
        refuse(fmt::format("the element <{}> is not closed", open_.back()));
    if (left_.empty())
        return {};
    XmlPiece piece{.kind = XmlPiece::Kind::text, .name = "", .text = "", .line = line_};
    if (left_.starts_with("<![CDATA[")) {
        take(9);
        piece.text = take_to("]]>", "a CDATA section");
        return piece;
    }
    if (left_.starts_with('<'))
        return tag();
    piece.text = decoded(take(std::min(left_.find('<'), left_.size())));
    return piece;
}

/// Takes the text up to the end of a tag, which is not in quotes.
std::string_view XmlReader::take_tag() {
    char quote = '\0';
    for (std::size_t i = 0; i < left_.size(); ++i) {
        const char each = left_[i];
        if (quote == '\0' && each == '>') {
            const std::string_view taken = take(i);
            take(1);
            return taken;
        }
        if (each == '"' || each == '\'')
            quote = quote == '\0' ? each : quote == each ? '\0' : quote;
    }
    refuse("a tag is not closed");
}

XmlPiece XmlReader::tag() {
    XmlPiece piece{.kind = XmlPiece::Kind::begin, .name = "", .text = "", .line = line_};
    take(1);
    std::string_view text = take_tag();
    if (text.starts_with('/')) {
        piece.kind = XmlPiece::Kind::end;
        piece.name = local_name(text.substr(1, text.find_last_not_of(blank)));
        if (open_.empty() || open_.back() != piece.name)
            refuse(fmt::format("</{}> closes an element that is not open", piece.name),
                   open_.empty() ? "" : fmt::format("the open element is <{}>", open_.back()));
        open_.pop_back();
        return piece;
    }
    end_follows_ = text.ends_with('/');
    text.remove_suffix(end_follows_ ? 1 : 0);
    const std::size_t end = std::min(text.find_first_of(blank), text.size());
    piece.name = local_name(text.substr(0, end));
    read_attributes(piece, text.substr(end));
    open_.push_back(piece.name);
    if (open_.size() > deepest_graph)
        refuse(fmt::format("the elements are nested deeper than {} levels", deepest_graph));
    return piece;
}

void XmlReader::read_attributes(XmlPiece& piece, std::string_view tag) {
    while (tag.find_first_not_of(blank) != tag.npos) {
        tag.remove_prefix(tag.find_first_not_of(blank));
        const std::size_t equals = tag.find('='), open = tag.find_first_of("\"'");
        if (equals == tag.npos || open == tag.npos || open < equals || tag.find(tag[open], open + 1) == tag.npos)
            refuse(fmt::format("the tag <{}> has an attribute without a quoted value", piece.name));
        const std::size_t close = tag.find(tag[open], open + 1);
        const std::string_view name = tag.substr(0, tag.find_last_not_of(blank, equals - 1) + 1);
        if (!name.starts_with("xmlns"))
            piece.attributes[local_name(name)] = decoded(tag.substr(open + 1, close - open - 1));
        tag.remove_prefix(close + 1);
    }
}

std::string XmlReader::decoded(std::string_view text) const {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '&') {
            out += text[i];
            continue;
        }
        const std::size_t end = std::min(text.find(';', i), text.size());
        const std::string_view name = text.substr(i + 1, end - i - 1).substr(0, 20);
        const auto replaced = entity_text(name);
        if (!replaced)
            refuse(fmt::format("the entity \"&{};\" is not known", name), "write the character itself");
        out += *replaced;
        i = end;
    }
    return out;
}

} // namespace placedpar::generate
