#include "explore/generate/graph.hpp"

#include <graphviz/cgraph.h>
#undef FALSE // macros of cgraph.h that are words elsewhere
#undef NIL
#undef NOT
#undef TRUE

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace placedpar::generate {

namespace {

struct CloseDot {
    void operator()(Agraph_t* graph) const { agclose(graph); }
    void operator()(std::FILE* stream) const { std::fclose(stream); }
};
using DotGraph = std::unique_ptr<Agraph_t, CloseDot>;

/// Graphviz's library has one reader for the whole program, and reports errors in pieces to a function without context.
std::string dot_errors;

int note_dot_error(char* piece) {
    dot_errors += piece;
    return 0;
}

/// Throws RefusedText if the library has reported an error, such as "Error:  syntax error in line 3 near '-'".
void refuse_dot_errors(const std::shared_ptr<const SourceFile>& file) {
    constexpr std::string_view before_line = " in line ";
    if (dot_errors.empty())
        return;
    const std::size_t begin = std::min(dot_errors.find_first_not_of(' ', dot_errors.find(':') + 1), dot_errors.size());
    const std::string text = dot_errors.substr(begin, dot_errors.find('\n', begin) - begin);
    const std::size_t number = text.find(before_line);
    refuse_graph(
        file, text,
        "edges are written \"--\" in a graph and \"->\" in a digraph; names and values such as \"my-node\" and "
        "\"10M\" need quotes",
        number == text.npos ? 0 : std::strtoul(text.c_str() + number + before_line.size(), nullptr, 10));
}

DotGraph parse_dot(const std::shared_ptr<const SourceFile>& file) {
    std::string text = file->text();
    const std::unique_ptr<std::FILE, CloseDot> stream(::fmemopen(text.data(), text.size(), "r"));
    dot_errors.clear();
    agseterrf(note_dot_error);
    agsetfile(nullptr); // counts lines from 1
    DotGraph graph(agread(stream.get(), nullptr));
    bool goes_on = false;
    for (DotGraph next; graph; goes_on = true) { // leaves nothing in the library for the next file
        next.reset(agread(stream.get(), nullptr));
        if (!next)
            break;
    }
    refuse_dot_errors(file);
    if (!graph)
        refuse_graph(file, "expected \"graph\" or \"digraph\"", "the language of Graphviz");
    if (goes_on)
        refuse_graph(file, "the file goes on after the end of the graph", "one file has one graph");
    return graph;
}

GraphAttributes attributes_of(Agraph_t* graph, int kind, void* of) {
    GraphAttributes attributes;
    for (Agsym_t* each = agnxtattr(graph, kind, nullptr); each; each = agnxtattr(graph, kind, each))
        if (const std::string value = agxget(of, each); !value.empty())
            attributes[each->name] = value;
    return attributes;
}

/// Returns the edges in the order of the file.
std::vector<Agedge_t*> edges_of(Agraph_t* graph) {
    std::vector<Agedge_t*> edges;
    for (Agnode_t* node = agfstnode(graph); node; node = agnxtnode(graph, node))
        for (Agedge_t* edge = agfstout(graph, node); edge; edge = agnxtout(graph, edge))
            edges.push_back(edge);
    std::ranges::sort(edges, {}, [](const Agedge_t* edge) -> unsigned { return edge->base.tag.seq; });
    return edges;
}

} // namespace

Graph read_dot(const std::shared_ptr<const SourceFile>& file) {
    const DotGraph dot = parse_dot(file);
    GraphBuilder builder(file, agisdirected(dot.get()) != 0);
    for (Agnode_t* node = agfstnode(dot.get()); node; node = agnxtnode(dot.get(), node))
        builder.add_node(agnameof(node), attributes_of(dot.get(), AGNODE, node));
    for (Agedge_t* edge : edges_of(dot.get()))
        builder.add_edge(agnameof(agtail(edge)), agnameof(aghead(edge)), attributes_of(dot.get(), AGEDGE, edge));
    return std::move(builder).take();
}

} // namespace placedpar::generate
