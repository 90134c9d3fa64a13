#include "picture/boxes.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "netlist/network/names.hpp"
#include "netlist/print/text.hpp"
#include "text/counted.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace placedpar::picture {

namespace {

constexpr double gap_across = 80, gap_down = 64, inset = 8;
constexpr double narrowest = 96;
constexpr std::size_t most_in_column = 8, longest_text = 26;

double round_up(double length, double unit) { return std::ceil(length / unit) * unit; }
double to_raster(double length) { return std::round(length / pitch) * pitch; }

/// Leaves out the folder from the name of a kind of processes that a file defines.
std::string without_folder(const std::string& kind) { return kind.substr(kind.find_last_of('/') + 1); }

/// Shortens a long text so that it ends in "..". Cuts between characters of UTF-8.
std::string shortened(const std::string& text) {
    if (text.size() <= longest_text)
        return text;
    std::size_t end = longest_text - 2;
    while (end > 0 && (text[end] & 0xC0) == 0x80) // a byte in the middle of a character
        --end;
    return text.substr(0, end) + "..";
}

std::string facts_of(const Node& node) {
    return node.kind->links == LinkRole::edge ? "" : node.type + print_drawn_facts(node);
}

/// The size of a node's box, in pixels. The box has room for its texts and its wires.
struct Size {
    double width = narrowest, height = heading_height;
};

class NodeDrawer {
public:
    NodeDrawer(const Network& network, const std::vector<Span>& spans)
        : n_(network), nodes_(network.nodes.size()), sizes_(network.nodes.size()), wires_(network.nodes.size()) {
        for (const Span& span : spans)
            for (auto node : {span.from.node, span.to.node})
                ++wires_[node];
    }

    std::vector<DrawnNode> draw(const std::vector<Point>& places) {
        find_texts();
        find_sizes();
        place(places);
        for (DrawnNode& node : nodes_)
            place_processes(node);
        return std::move(nodes_);
    }

private:
    void find_texts() {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            nodes_[i].name = shortened(n_.nodes[i].name);
            nodes_[i].facts = facts_of(n_.nodes[i]);
        }
        for (std::size_t i = 0; i < n_.processes.size(); ++i)
            add_process(i);
        for (auto [node, count] : channels_inside())
            nodes_[node].inside = counted(count, "channel") + " inside";
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (n_.nodes[i].runs_own_code && !n_.nodes[i].image)
                nodes_[i].inside = shortened(print_boot(n_.nodes[i]));
    }

    void add_process(std::size_t index) {
        const ProcessInstance& process = n_.processes[index];
        if (n_.nodes[process.node].kind->is_set_by_link())
            return; // the picture omits the logic of a switch: the wire to its configuration link implies this logic
        auto name = shortened(process.name) + (process.high_priority ? " !" : "");
        auto kind = process.kind.empty() ? "no program" : shortened(without_folder(process.kind));
        nodes_[process.node].processes.push_back({index, name, kind, {}, 0});
    }

    std::map<std::size_t, std::size_t> channels_inside() const {
        std::map<std::size_t, std::size_t> counts;
        for (const NetworkChannel& channel : n_.channels)
            if (channel.placement.kind == ChannelPlacement::Kind::soft)
                ++counts[channel.from.at_edge() ? channel.to.node : channel.from.node];
        return counts;
    }

    /// Finds the sizes of all boxes. All nodes of an array get the size of the largest node of the array.
    void find_sizes() {
        std::map<std::string_view, Size> largest;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            Size size = size_of(i), &array = largest[base_name(n_.nodes[i].name)];
            array = {std::max(size.width, array.width), std::max(size.height, array.height)};
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            sizes_[i] = largest[base_name(n_.nodes[i].name)];
    }

    static std::size_t columns_of(const DrawnNode& node) {
        return (node.processes.size() + most_in_column - 1) / most_in_column;
    }

    static double width_of_column(const DrawnNode& node) {
        double width = 0;
        for (const ProcessLine& line : node.processes)
            width = std::max(width, width_of(line.name, process_size) + inset + width_of(line.kind, kind_size));
        return width + inset;
    }

    Size size_of(std::size_t index) const {
        const DrawnNode& node = nodes_[index];
        double text = std::max(
            {width_of(node.name, name_size, true), width_of(node.facts, fact_size), width_of(node.inside, kind_size)});
        auto columns = columns_of(node);
        double width = std::max(text, static_cast<double>(columns) * width_of_column(node)) + 2 * inset;
        auto rows = std::min(node.processes.size(), most_in_column) + (node.inside.empty() ? 0 : 1);
        double height = heading_height + static_cast<double>(rows) * process_height + (rows == 0 ? 0 : inset);
        // Each side has room for a third of the wires, with a distance of twice the pitch.
        double side = 2 * pitch * (static_cast<double>(wires_[index]) / 3 + 1);
        return {round_up(std::max({width, narrowest, side}), 2 * pitch), round_up(std::max(height, side), 2 * pitch)};
    }

    /// Converts cells to pixels. A column is as wide as its widest box, and a row is as high as its highest box. A box
    /// between two columns or rows counts for both.
    class Scale {
    public:
        Scale(const std::vector<double>& cells, const std::vector<double>& lengths, double gap) {
            double most = *std::ranges::max_element(cells);
            least_ = std::floor(*std::ranges::min_element(cells));
            std::vector<double> longest(static_cast<std::size_t>(std::ceil(most) - least_) + 2, narrowest / 2);
            for (std::size_t i = 0; i < cells.size(); ++i)
                for (double cell : {std::floor(cells[i]), std::ceil(cells[i])}) {
                    double& length = longest[static_cast<std::size_t>(cell - least_)];
                    length = std::max(length, lengths[i]);
                }
            centres_ = {0};
            for (std::size_t i = 0; i + 1 < longest.size(); ++i)
                centres_.push_back(centres_.back() + round_up((longest[i] + longest[i + 1]) / 2 + gap, 2 * pitch));
        }

        double operator()(double cell) const {
            auto whole = static_cast<std::size_t>(std::floor(cell) - least_);
            double part = cell - std::floor(cell);
            return to_raster(centres_[whole] + part * (centres_[whole + 1] - centres_[whole]));
        }

    private:
        double least_;
        std::vector<double> centres_;
    };

    void place(const std::vector<Point>& places) {
        if (places.empty())
            return;
        std::vector<double> x, y, widths, heights;
        for (std::size_t i = 0; i < places.size(); ++i) {
            x.push_back(places[i].x);
            y.push_back(places[i].y);
            widths.push_back(sizes_[i].width);
            heights.push_back(sizes_[i].height);
        }
        Scale across(x, widths, gap_across), down(y, heights, gap_down);
        for (std::size_t i = 0; i < places.size(); ++i)
            nodes_[i].box = {{across(x[i]), down(y[i])}, sizes_[i].width, sizes_[i].height};
    }

    static void place_processes(DrawnNode& node) {
        double width = node.processes.empty() ? 0 : (node.box.width - inset) / static_cast<double>(columns_of(node));
        for (std::size_t i = 0; i < node.processes.size(); ++i) {
            double left = node.box.left() + inset + static_cast<double>(i / most_in_column) * width;
            double top = node.box.top() + heading_height + static_cast<double>(i % most_in_column) * process_height;
            node.processes[i].at = {left, top + 13};
            node.processes[i].kind_at = left + width - inset;
        }
    }

    const Network& n_;
    std::vector<DrawnNode> nodes_;
    std::vector<Size> sizes_;
    std::vector<std::size_t> wires_;
};

} // namespace

double width_of(const std::string& text, double size, bool bold) {
    return static_cast<double>(text.size()) * size * (bold ? 0.68 : 0.61);
}

std::vector<DrawnNode> draw_nodes(const Network& network, const std::vector<Span>& spans,
                                  const std::vector<Point>& places) {
    return NodeDrawer(network, spans).draw(places);
}

} // namespace placedpar::picture
