#include "picture/svg.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "netlist/print/buses_as_wires.hpp"
#include "netlist/print/pieces_as_wires.hpp"
#include "netlist/print/text.hpp"
#include "picture/fault_marks.hpp"
#include "picture/picture.hpp"
#include "picture/software.hpp"
#include "picture/svg_pen.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace placedpar::picture {

namespace {

constexpr std::size_t longest_tooltip = 4000;
constexpr double border = 24, title_height = 32, legend_line = 24, curve = 14;

/// The style of the drawing. The drawing is readable without colours, because shapes make the same distinctions.
constexpr const char* style =
    R"(.title { font-size: 14px; font-weight: bold; }
.name { font-size: 13px; font-weight: bold; text-anchor: middle; }
.facts, .key { font-size: 10px; }
.facts { fill: #445566; text-anchor: middle; }
.process { font-size: 11px; }
.kind { font-size: 9px; fill: #667788; text-anchor: end; }
.inside { font-size: 9px; fill: #667788; text-anchor: middle; }
.link { font-size: 9px; fill: #16324a; text-anchor: middle; }
.count { font-size: 10px; fill: #16324a; }
.over { paint-order: stroke; stroke: #ffffff; stroke-width: 4px; stroke-linejoin: round; }
.frame { fill: #ffffff; stroke-width: 1.4; }
.cross { stroke-width: 0.6; }
.edge .frame { stroke-dasharray: 5 3; }
.wire { fill: none; stroke: #3b5b7a; stroke-width: 1.6; }
.idle { stroke: #8898a8; stroke-dasharray: 2 3; }
.channels rect { fill: #ffffff; stroke: #3b5b7a; stroke-width: 0.8; }
.channels path, .head { fill: #3b5b7a; }
)";

/// This style is added if transputers execute the code of a bootable file.
constexpr const char* style_of_code = R"(.booted .frame { stroke-width: 3; }
)";
/// This style is added if there are faults.
constexpr const char* style_of_faults =
    R"(.struck { fill: none; stroke: #16202a; stroke-width: 3.6; stroke-dasharray: 9 5; }
.fault rect { fill: #ffffff; stroke: #16202a; stroke-width: 1; }
.fault text { font-size: 10px; font-weight: bold; text-anchor: middle; }
)";

SvgPen frame(const Box& box, const Drawing& drawing) {
    SvgAttributes colours{{"class", "frame"}, {"stroke", drawing.frame}}, filled = colours;
    filled.emplace_back("style", "fill: " + drawing.heading);
    std::string cross = svg_corners({{box.left(), box.top()}, {box.right(), box.bottom()}}) + " " +
                        svg_corners({{box.left(), box.bottom()}, {box.right(), box.top()}});
    SvgPen pen;
    switch (drawing.shape) {
    case Drawing::Shape::crossed_box:
        return pen.rect(box, filled).path(cross, {{"class", "cross"}, {"stroke", drawing.frame}});
    case Drawing::Shape::ellipse: return pen.ellipse(box.centre, box.width / 2, box.height / 2, colours);
    case Drawing::Shape::box: break;
    }
    const SvgAttribute rounded{"rx", drawing.in_first_row ? "10" : ""};
    colours.push_back(rounded), filled.push_back(rounded);
    if (box.height < heading_height + process_height)
        return pen.rect(box, filled);
    Box heading{{box.centre.x, box.top() + 18}, box.width, 36};
    return pen.rect(box, colours).rect(heading, {{"fill", drawing.heading}, {"stroke", drawing.frame}, rounded});
}

/// Returns the path data of a line whose corners are rounded.
std::string curved(const Path& path) {
    std::string data = "M" + svg_point(path.front());
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        Point before = path[i - 1] - path[i], after = path[i + 1] - path[i];
        double reach = std::min({curve, distance({}, before) / 2, distance({}, after) / 2});
        data += fmt::format(" L{} Q{} {}", svg_point(path[i] + (reach / distance({}, before)) * before),
                            svg_point(path[i]), svg_point(path[i] + (reach / distance({}, after)) * after));
    }
    return data + " L" + svg_point(path.back());
}

/// Returns the path data of an arrow head at the end of a line.
std::string arrow_head(Point before, Point tip) {
    Point along = 1 / distance(before, tip) * (tip - before), aside{-along.y, along.x};
    return svg_corners({tip, tip + -9 * along + 4 * aside, tip + -9 * along + -4 * aside}) + " Z";
}

/// Returns the path data of an arrow about 7 pixels long, which points right, left, down or up.
std::string arrow(Point centre, bool upright, bool onward) {
    Point along = upright ? Point{0, 1} : Point{1, 0}, aside{along.y, along.x};
    Point tip = centre + (onward ? 3.5 : -3.5) * along, back = centre - (onward ? 3 : -3) * along;
    return svg_corners({tip, back + 3.2 * aside, back - 3.2 * aside}) + " Z";
}

/// Draws a line as a symbol in the legend.
SvgPen line_across(const char* style_class) { return SvgPen().path("M0 0 L36 0", {{"class", style_class}}); }

/// The subject of the picture: processors and wires, or processes and channels.
enum class View { hardware, software };

class SvgPrinter {
public:
    SvgPrinter(const Network& network, Picture picture, View view)
        : n_(network), view_(view), picture_(std::move(picture)), directions_(network.connections.size()),
          carried_(channels_on_wires()),
          marks_(view == View::hardware ? fault_marks(n_, picture_) : std::vector<FaultMark>{}) {}

    std::string print() {
        Box drawing = extent();
        SvgPen legend = print_legend({drawing.left(), drawing.bottom() + 2 * border}, std::max(drawing.width, 640.));
        std::string title = title_of();
        double width =
            std::max({drawing.width, legend_right_ - drawing.left(), width_of(title, 14, true)}) + 2 * border;
        double top = drawing.top() - border - title_height, height = legend_bottom_ - top + border;
        pen_.text({drawing.left(), top + border}, "title", title);
        for (std::size_t i = 0; i < n_.nodes.size(); ++i)
            print_frame(i);
        for (std::size_t i = 0; i < n_.connections.size(); ++i)
            print_wire(i);
        for (std::size_t i = 0; i < n_.nodes.size(); ++i)
            print_texts(i);
        for (const FaultMark& mark : marks_)
            print_mark(mark);
        for (std::size_t i = 0; i < n_.connections.size(); ++i)
            print_labels(i);
        return pen_.add(legend).document({{drawing.left() - border + width / 2, top + height / 2}, width, height},
                                         style + std::string(executes_code() ? style_of_code : "") +
                                             (marks_.empty() ? "" : style_of_faults));
    }

private:
    Box extent() const {
        if (n_.nodes.empty())
            return {};
        std::vector<Box> boxes{extent_of(picture_)};
        for (const FaultMark& mark : marks_)
            boxes.push_back(mark.box);
        return around(boxes);
    }

    /// Draws a fault mark over the wire or the node that it affects. Numbers of links and channels are drawn later,
    /// above the mark.
    void print_mark(const FaultMark& mark) {
        std::string struck =
            mark.wire ? data_of(picture_.wires[*mark.wire]) : outline_of(grown(picture_.nodes[*mark.node].box, 3));
        SvgPen strike;
        strike.path(struck, {{"class", "struck"}}).rect(mark.box, {{"rx", "3"}});
        strike.text({mark.box.centre.x, mark.box.centre.y + 3.5}, "mark", mark.text);
        pen_.group({{"class", "fault"}}, strike, mark.statement);
    }

    static std::string outline_of(const Box& box) {
        double left = box.left(), right = box.right(), top = box.top(), bottom = box.bottom();
        return svg_corners({{left, top}, {right, top}, {right, bottom}, {left, bottom}}) + " Z";
    }

    bool executes_code() const {
        return std::ranges::any_of(n_.nodes, [](const Node& node) { return node.runs_own_code; });
    }

    std::string title_of() const {
        if (view_ == View::software)
            return fmt::format("{}: {}, {}", std::filesystem::path(n_.source_path).filename().string(),
                               counted(count_processes(), "process", "processes"),
                               counted(n_.channels.size(), "channel", "channels"));
        std::string title = fmt::format("{}: {}, {}", std::filesystem::path(n_.source_path).filename().string(),
                                        counted(count_processors(n_), "processor", "processors"),
                                        counted(count_links(), "wire", "wires"));
        const auto files = std::ranges::count_if(n_.nodes, [](const Node& node) { return !node.boot_file.empty(); });
        if (files > 0)
            title += ", " + counted(static_cast<std::size_t>(files), "bootable file");
        if (files == 0 || !n_.processes.empty())
            title += fmt::format(", {}, {}", counted(n_.processes.size(), "process", "processes"),
                                 counted(n_.channels.size(), "channel", "channels"));
        return title;
    }

    /// Counts the connections that are links. The other connections lead to buses.
    std::size_t count_links() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(n_.connections, [](const LinkConnection& wire) { return wire.bits_per_second > 0; }));
    }

    /// Returns the names of a wire's ends, such as "sun - vme.slot[1]".
    std::string ends_of(const LinkConnection& wire) const {
        if (wire.bits_per_second == 0)
            return fmt::format("{} - {}.slot[{}]", n_.nodes[wire.a.node].name, n_.nodes[wire.b.node].name, wire.b.link);
        return link_name(n_.nodes, wire.a) + " - " + link_name(n_.nodes, wire.b);
    }

    /// Counts the nodes that are processes. The other nodes are edges.
    std::size_t count_processes() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(n_.nodes, [](const Node& node) { return node.kind->executes != Execution::none; }));
    }

    /// Returns the names of the channels on each wire, and stores the directions of the channels.
    std::vector<std::string> channels_on_wires() {
        std::vector<std::string> names(n_.connections.size());
        for (const NetworkChannel& channel : n_.channels)
            for (const RouteHop& hop : channel.placement.route) {
                auto& [onward, back] = directions_[hop.connection];
                (hop.from_a_to_b ? onward : back) = true;
                if (auto& text = names[hop.connection]; text.size() < longest_tooltip)
                    text += "\n" + channel.name;
                else if (!text.ends_with("..."))
                    text += "\n...";
            }
        return names;
    }

    void print_frame(std::size_t index) {
        const Node& node = n_.nodes[index];
        pen_.group({{"class", "node " + class_of(node)}, {"data-node", node.name}},
                   frame(picture_.nodes[index].box, node.kind->drawing), node.name + " (" + node.type + ")");
    }

    /// Returns the kind's style class as one word. With a blank, "link adapter" would be two classes, and "link" is the
    /// class of link numbers.
    static std::string class_of(const Node& node) {
        std::string name = node.kind->links == LinkRole::edge ? "edge" : node.kind->name;
        std::ranges::replace(name, ' ', '-');
        return node.runs_own_code ? name + " booted" : name;
    }

    void print_wire(std::size_t index) {
        const LinkConnection& wire = n_.connections[index];
        std::string ends = ends_of(wire);
        std::string about = view_ == View::software || wire.bits_per_second == 0
                                ? ends
                                : fmt::format("{}, {:g} Mbit/s", ends, static_cast<double>(wire.bits_per_second) / 1e6);
        const char* style_class = is_idle(index) ? "wire idle" : "wire";
        pen_.path(data_of(picture_.wires[index]), {{"class", style_class}, {"data-wire", ends}},
                  about + carried_[index]);
        if (view_ == View::software)
            print_heads(index);
    }

    bool is_idle(std::size_t index) const {
        return carried_[index].empty() && !is_used_by_code(n_, n_.connections[index]);
    }

    /// Draws an arrow head at each end to which a channel leads.
    void print_heads(std::size_t index) {
        const Path& path = picture_.wires[index].spans.front();
        auto [onward, back] = directions_[index];
        if (onward)
            pen_.path(arrow_head(path[path.size() - 2], path.back()), {{"class", "head"}});
        if (back)
            pen_.path(arrow_head(path[1], path.front()), {{"class", "head"}});
    }

    /// Returns the path data of a wire. Within a switch, a straight line joins the two links.
    static std::string data_of(const DrawnWire& wire) {
        std::string data;
        for (const Path& path : wire.spans)
            data += (data.empty() ? "" : " L" + svg_point(path.front()) + " ") + curved(path);
        return data;
    }

    void print_texts(std::size_t index) {
        const DrawnNode& node = picture_.nodes[index];
        const Drawing& drawing = n_.nodes[index].kind->drawing;
        bool headed = drawing.shape == Drawing::Shape::box;
        bool only_heading = node.box.height < heading_height + process_height;
        double top = headed && !only_heading ? node.box.top() : node.box.centre.y - (node.facts.empty() ? 9 : 18);
        std::string over = drawing.shape == Drawing::Shape::crossed_box ? " over" : "";
        SvgPen texts;
        texts.text({node.box.centre.x, top + (node.facts.empty() ? 14 : 16)}, "name" + over, node.name);
        if (!node.facts.empty())
            texts.text({node.box.centre.x, top + 29}, "facts" + over, node.facts);
        for (const ProcessLine& line : node.processes)
            print_process(line, texts);
        if (!node.inside.empty())
            texts.text({node.box.centre.x, node.box.bottom() - (n_.nodes[index].runs_own_code ? 11 : 6)}, "inside",
                       node.inside);
        pen_.group({{"class", "texts"}}, texts);
    }

    void print_process(const ProcessLine& line, SvgPen& pen) {
        const ProcessInstance& process = n_.processes[line.process];
        pen.group({{"class", "placed"}, {"data-process", process.name}},
                  SvgPen().text(line.at, "process", line.name).text({line.kind_at, line.at.y}, "kind", line.kind),
                  process.name + ", " + (process.kind.empty() ? "no program" : process.kind));
    }

    void print_labels(std::size_t index) {
        const DrawnWire& wire = picture_.wires[index];
        for (const LinkLabel& link : wire.links)
            pen_.text({link.box.centre.x, link.box.bottom() - 1.5}, "link over", link.text);
        bool said = view_ == View::software && wire.channels && wire.channels->onward <= 1 && wire.channels->back <= 1;
        if (wire.channels && !said) // the arrows show a single channel in each direction
            pen_.add(print_count(*wire.channels));
    }

    /// Draws the numbers of channels: `back` on the left, `onward` on the right.
    static SvgPen print_count(const ChannelCount& count) {
        SvgPen halves;
        halves.rect(count.box, {{"rx", "4"}});
        if (count.back > 0)
            print_half(count, count.box.left() + 4, count.back, false, halves);
        if (count.onward > 0)
            print_half(count, count.box.right() - 4, count.onward, true, halves);
        return SvgPen().group({{"class", "channels"}}, halves);
    }

    /// Draws one number, with its arrow on the outer side.
    static void print_half(const ChannelCount& count, double end, std::size_t channels, bool onward, SvgPen& pen) {
        auto digits = fmt::format("{}", channels);
        Point text{onward ? end - arrow_width - digit_width * static_cast<double>(digits.size()) : end + arrow_width,
                   count.box.centre.y + 3.5};
        pen.path(arrow({end + (onward ? -3.5 : 3.5), count.box.centre.y}, count.upright, onward));
        pen.text(text, "count", digits);
    }

    /// Draws the legend with `corner` as its upper left corner, in lines of at most `width`.
    SvgPen print_legend(Point corner, double width) {
        legend_start_ = legend_at_ = corner;
        legend_width_ = width;
        std::set<std::string> seen;
        for (const Node& node : n_.nodes)
            if (seen.insert(class_of(node)).second)
                add_to_legend(40, frame({{20, 0}, 32, 16}, node.kind->drawing),
                              node.runs_own_code ? "transputer that executes its own code" : node.kind->drawing.legend,
                              class_of(node));
        add_wires_to_legend();
        if (!marks_.empty())
            add_to_legend(40, line_across("struck"), "fails during the run, as its label states");
        if (std::ranges::any_of(n_.processes, &ProcessInstance::high_priority) ||
            std::ranges::any_of(n_.nodes, [](const Node& node) { return node.name.ends_with(" !"); }))
            add_to_legend(12, SvgPen().text({2, 4}, "process", "!"), "process of high priority");
        legend_bottom_ = legend_at_.y + 8;
        return std::move(legend_);
    }

    void add_wires_to_legend() {
        if (view_ == View::software)
            return add_channels_to_legend();
        bool channels = false, code = false, idle = false, wires = false, slots = false;
        for (std::size_t i = 0; i < carried_.size(); ++i) {
            (leads_to_slot(n_.connections[i]) ? slots : wires) = true;
            channels = channels || !carried_[i].empty();
            code = code || is_used_by_code(n_, n_.connections[i]);
            idle = idle || is_idle(i);
        }
        const std::string line = slots ? "line" : "wire";
        if (channels || code)
            add_to_legend(40, line_across("wire"),
                          line + (!code       ? " that carries channels"
                                  : !channels ? " that carries bytes of programs"
                                              : " that carries channels, or bytes of programs"));
        if (channels) {
            add_to_legend(48, print_count({{{22, 0}, width_of_count(2, 1), 14}, 1, 2, false}), "how many, each way");
        }
        if (idle)
            add_to_legend(40, line_across("wire idle"), line + " without a channel");
        if (!carried_.empty())
            add_to_legend(12, SvgPen().text({5, 3}, "link", "0"),
                          !slots   ? "number of a link"
                          : !wires ? "number of a slot"
                                   : "number of a link or slot");
    }

    /// Returns whether the line stands for a device in the slot of a bus or a memory.
    bool leads_to_slot(const LinkConnection& line) const { return n_.nodes[line.b.node].kind->medium.has_value(); }

    void add_channels_to_legend() {
        if (carried_.empty())
            return;
        SvgPen one_way = line_across("wire").path(arrow_head({0, 0}, {36, 0}), {{"class", "head"}});
        add_to_legend(40, one_way, "channel");
        add_to_legend(40, one_way.path(arrow_head({36, 0}, {0, 0}), {{"class", "head"}}), "a channel each way");
        add_to_legend(36, SvgPen().text({16, 3}, "link", "name"), "of the sender's port");
    }

    void add_to_legend(double room, SvgPen sign, const std::string& about, const std::string& kind = "") {
        double width = room + width_of(about, fact_size) + 20;
        if (legend_at_.x > legend_start_.x && legend_at_.x + width > legend_start_.x + legend_width_)
            legend_at_ = {legend_start_.x, legend_at_.y + legend_line};
        legend_.group({{"class", "legend " + kind}, {"transform", fmt::format("translate({})", svg_point(legend_at_))}},
                      sign.text({room, 3.5}, "key", about));
        legend_at_.x += width;
        legend_right_ = std::max(legend_right_, legend_at_.x);
    }

    const Network& n_;
    View view_;
    Picture picture_;
    /// For each wire, whether channels lead from its end `a` to its end `b`, and from `b` to `a`.
    std::vector<std::pair<bool, bool>> directions_;
    std::vector<std::string> carried_; ///< for each wire: names of its channels; "" if there are none
    std::vector<FaultMark> marks_;
    SvgPen pen_, legend_;
    Point legend_start_, legend_at_;
    double legend_width_ = 0, legend_right_ = 0, legend_bottom_ = 0;
};

} // namespace

} // namespace placedpar::picture

namespace placedpar {

std::string print_svg(const Network& with_buses) {
    Network network = with_buses_as_wires(with_pieces_as_wires(with_buses));
    return picture::SvgPrinter(network, picture::draw(network, picture::spans_of(network)), picture::View::hardware)
        .print();
}

std::string print_software_svg(const Network& network) {
    picture::Software software = picture::software_of(network);
    auto drawn = picture::draw(software.network, software.spans, software.places);
    return picture::SvgPrinter(software.network, std::move(drawn), picture::View::software).print();
}

} // namespace placedpar
