#include "picture/wiring.hpp"

#include <fmt/format.h>

namespace placedpar::picture {

namespace {

Span span_between(std::size_t index, const LinkEnd& from, const LinkEnd& to) {
    auto label = [](const LinkEnd& end) {
        return end.at_edge() ? "" : end.link == configuration_link ? "config" : fmt::format("{}", end.link);
    };
    return {index, from, to, label(from), label(to)};
}

void add_spans(std::size_t index, const LinkConnection& wire, std::vector<Span>& spans) {
    LinkEnd from = wire.a;
    for (const SwitchCrossing& crossing : wire.crossings) {
        spans.push_back(span_between(index, from, {crossing.node, crossing.from_link}));
        from = {crossing.node, crossing.to_link};
    }
    spans.push_back(span_between(index, from, wire.b));
}

} // namespace

std::vector<Span> spans_of(const Network& network) {
    std::vector<Span> spans;
    for (std::size_t i = 0; i < network.connections.size(); ++i)
        add_spans(i, network.connections[i], spans);
    return spans;
}

Wiring::Wiring(const Network& network) : neighbours_(network.nodes.size()) {
    for (const Span& span : spans_of(network)) {
        neighbours_[span.from.node].push_back(span.to.node);
        neighbours_[span.to.node].push_back(span.from.node);
        pairs_.emplace(span.from.node, span.to.node);
        pairs_.emplace(span.to.node, span.from.node);
    }
}

} // namespace placedpar::picture
