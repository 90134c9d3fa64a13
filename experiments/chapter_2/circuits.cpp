#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/circuit.hpp"
#include "picture/boxes.hpp"
#include "picture/svg_pen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

using picture::Box;
using picture::svg_corners;
using picture::SvgPen;
using At = picture::Point;

constexpr double column_width = 190, circuit_row_height = 178, caption_height = 34, pump_y = 28, junction_y = 76,
                 cylinder_y = 140, first_x = 66;

constexpr const char* circuit_style = R"(.title { font-size: 15px; font-weight: bold; }
.caption { font-size: 12px; font-weight: bold; }
.name { font-size: 11px; text-anchor: middle; }
.small { font-size: 10px; text-anchor: middle; }
.line { stroke: #3b5b7a; stroke-width: 1.8; fill: none; }
.flow { stroke: #3b5b7a; stroke-width: 1.8; fill: none; marker-end: url(#flow); }
.orifice { fill: #ffffff; stroke: #3b5b7a; stroke-width: 1.4; }
.pump { fill: #f3e9c9; stroke: #7a6a3b; stroke-width: 1.4; }
.cylinder { fill: #d5e3f0; stroke: #3b5b7a; stroke-width: 1.4; }
.junction { fill: #16202a; }
)";
constexpr const char* flow_head =
    R"(<marker id="flow" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="6" markerHeight="6" orient="auto">)"
    R"(<path d="M0 1 L8 4 L0 7 Z" fill="#3b5b7a"/></marker>)";

std::string names_of(LinkSet links) {
    std::string names;
    for (Link link : all_links)
        if (links.contains(link))
            names += (names.empty() ? "" : ", ") + std::string(name_of(link));
    return names;
}

/// Draws one hydraulic circuit. Each link has a junction, at which the flow divides into its cylinder and the bypass.
/// The flow runs from left to right. The bypass of a junction leads to the junction one column to its right. If two
/// bypasses lead to one junction, the second branch has a row of its own.
class CircuitDrawing {
public:
    CircuitDrawing(SvgPen& pen, const Circuit& circuit, At corner)
        : pen_(pen), circuit_(circuit), corner_(corner), steps_(circuit.size()), rows_(circuit.size()) {
        for (std::size_t j = circuit.size(); j-- > 0;)
            if (circuit[j].through == Through::junction)
                put_before(j, circuit[j].next);
        for (std::size_t j = 0; j < circuit.size(); ++j)
            draw(j);
    }

    /// Returns the position of a link's junction. REQUIRES: the link is in the circuit.
    At at(Link link) const {
        return at(static_cast<std::size_t>(std::ranges::find(circuit_, link, &Junction::link) - circuit_.begin()));
    }
    double width() const { return first_x + column_width * static_cast<double>(most(steps_) + 1); }
    double height() const { return circuit_row_height * static_cast<double>(most(rows_) + 1); }

private:
    static std::size_t most(const std::vector<std::size_t>& numbers) { return *std::ranges::max_element(numbers); }

    /// Places junction `j` one column to the left of `next`. If several junctions lead to `next`, only the last of
    /// these is in the row of `next`.
    void put_before(std::size_t j, std::size_t next) {
        steps_[j] = steps_[next] + 1;
        bool shares = std::none_of(
            circuit_.begin() + static_cast<std::ptrdiff_t>(j) + 1, circuit_.end(),
            [&](const Junction& other) { return other.through == Through::junction && other.next == next; });
        rows_[j] = shares ? rows_[next] : most(rows_) + 1;
    }

    At at(std::size_t j) const {
        return corner_ + At{first_x + column_width * static_cast<double>(most(steps_) - steps_[j]),
                            junction_y + circuit_row_height * static_cast<double>(rows_[j])};
    }

    void orifice(At middle, const std::string& name) {
        pen_.rect({middle, 44, 18}, {{"class", "orifice"}}).text(middle + At{0, 4}, "small", name);
    }

    void draw(std::size_t j) {
        const Junction& junction = circuit_[j];
        std::string symbol(symbol_of(junction.link)), name(name_of(junction.link));
        At here = at(j), cylinder = here + At{0, cylinder_y - junction_y};
        if (junction.pumps > 0)
            draw_pump(here, junction.pumps);
        pen_.path(svg_corners({here, cylinder - At{0, 16}}), {{"class", "flow"}});
        pen_.rect({cylinder, 104, 32}, {{"class", "cylinder"}, {"rx", "3"}});
        pen_.text(cylinder + At{0, -3}, "name", name).text(cylinder + At{0, 10}, "small", "C_" + symbol + "i");
        orifice(here + At{0, 24}, "a_i" + symbol);
        draw_bypass(here, junction, "a_e" + symbol);
        pen_.circle(here, 4, {{"class", "junction"}});
    }

    void draw_pump(At junction, int pumps) {
        At pump = junction + At{0, pump_y - junction_y};
        pen_.path(svg_corners({pump, junction - At{0, 4}}), {{"class", "flow"}});
        pen_.circle(pump, 14, {{"class", "pump"}});
        pen_.text(pump + At{0, 4}, "small", pumps == 1 ? "Q" : fmt::format("{} Q", pumps));
    }

    /// Draws the bypass, the path of the flow that does not enter the cylinder. The bypass leads to the next junction
    /// or to the tank, or is absent.
    void draw_bypass(At from, const Junction& junction, const std::string& name) {
        At straight = from + At{column_width - 4, 0};
        if (junction.through == Through::junction && at(junction.next).y != from.y) {
            At to = at(junction.next);
            pen_.path(svg_corners({from,
                                   from + At{column_width / 2 + 40, 0},
                                   {from.x + column_width / 2 + 40, to.y + 8},
                                   {to.x - 4, to.y + 8}}),
                      {{"class", "flow"}});
        } else if (junction.through == Through::junction) {
            pen_.path(svg_corners({from, straight}), {{"class", "flow"}});
        } else {
            draw_end(from, junction.through);
        }
        orifice(from + At{column_width / 2, 0}, name);
    }

    void draw_end(At from, Through through) {
        At end = from + At{column_width - 44, 0};
        pen_.path(svg_corners({from, end}), {{"class", through == Through::tank ? "flow" : "line"}});
        if (through == Through::nowhere)
            pen_.path(svg_corners({end + At{0, -9}, end + At{0, 9}}), {{"class", "line"}});
        pen_.text(end + At{20, 4}, "small", through == Through::tank ? "tank" : "shut");
    }

    SvgPen& pen_;
    const Circuit& circuit_;
    At corner_;
    std::vector<std::size_t> steps_; ///< number of columns between each junction and the last junction
    std::vector<std::size_t> rows_;
};

struct CaptionedCircuit {
    std::string caption;
    Circuit circuit;
    bool beside = false; ///< whether the circuit is drawn to the right of the previous circuit
};

std::string draw_circuits(const std::string& title, const std::vector<CaptionedCircuit>& circuits) {
    SvgPen pen;
    pen.text({12, 24}, "title", title);
    At corner{0, 36};
    double width = picture::width_of(title, 15, true) + 24, right = 0, bottom = corner.y;
    for (const auto& [caption, circuit, beside] : circuits) {
        corner = beside ? At{right, corner.y} : At{0, bottom};
        pen.text(corner + At{12, 18}, "caption", caption);
        CircuitDrawing drawing(pen, circuit, corner + At{0, caption_height - 14});
        right = corner.x + drawing.width();
        bottom = std::max(beside ? bottom : 0, corner.y + caption_height + drawing.height());
        width = std::max(width, right);
    }
    return pen.document({{width / 2, bottom / 2}, width, bottom}, circuit_style, flow_head);
}

/// Returns the circuits of a configuration with all links active.
std::vector<CaptionedCircuit> circuits_of(Configuration configuration) {
    std::vector<CaptionedCircuit> circuits;
    for (LinkSet group : coupled_groups(configuration))
        circuits.push_back({fmt::format("configuration {}: {}", name_of(configuration), names_of(group)),
                            circuit_of(configuration, group), !circuits.empty()});
    return circuits;
}

/// Returns the names, such as "b, d", of all configurations in which is(junction of this link) is true.
template <class Is>
std::string configurations_with(Link link, Is is) {
    std::string names;
    for (Configuration configuration : all_configurations)
        for (LinkSet group : coupled_groups(configuration)) {
            const Circuit circuit = circuit_of(configuration, group);
            if (std::ranges::any_of(circuit, [&](const Junction& at) { return at.link == link && is(at, circuit); }))
                names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(configuration));
        }
    return names;
}

/// Draws both branches as in configuration a. Dashed lines are the connections that other configurations add (Figure
/// 2.10).
std::string draw_cross_over() {
    constexpr At first_branch{0, 50};
    SvgPen pen;
    pen.text({12, 24}, "title", "The main circuit with its cross-over network");
    const Circuit one = circuit_of(Configuration::a, {Link::bucket, Link::boom}),
                  two = circuit_of(Configuration::a, {Link::stick, Link::swing});
    const CircuitDrawing branch_1(pen, one, first_branch), branch_2(pen, two, first_branch + At{0, circuit_row_height});
    auto check_valve = [&](At junction, Link link) {
        auto shut = [](const Junction& at, const Circuit&) { return at.through == Through::nowhere; };
        pen.text(junction + At{column_width / 2, 24}, "small", "shut in " + configurations_with(link, shut));
    };
    check_valve(branch_1.at(Link::bucket), Link::bucket);
    check_valve(branch_2.at(Link::swing), Link::swing);
    auto surplus = [&](At from, At to, Link giver, Link taker, double out, double across) {
        auto leads = [=](const Junction& at, const Circuit& circuit) {
            return at.through == Through::junction && circuit[at.next].link == taker;
        };
        double y = branch_1.at(Link::boom).y + across;
        pen.path(svg_corners({from + At{out, 0}, {from.x + out, y}, {to.x - 62, y}, to - At{62, 0}}),
                 {{"class", "flow"}, {"stroke-dasharray", "5 3"}});
        pen.text({to.x + 20, y - 4}, "small", "in " + configurations_with(giver, leads));
    };
    const At boom = branch_1.at(Link::boom), stick = branch_2.at(Link::stick);
    surplus(stick, boom, Link::stick, Link::boom, 136, 100);
    surplus(boom, stick, Link::boom, Link::stick, 124, 124);
    const double width = branch_1.width() + 20, height = first_branch.y + 2 * circuit_row_height;
    return pen.document({{width / 2, height / 2}, width, height}, circuit_style, flow_head);
}

std::vector<NamedDrawing> drawings() {
    std::vector<CaptionedCircuit> all;
    for (Configuration configuration : all_configurations)
        for (CaptionedCircuit& circuit : circuits_of(configuration))
            all.push_back(std::move(circuit));
    Circuit branch = circuit_of(Configuration::a, {Link::bucket, Link::boom});
    return {{"figure-2-10", draw_cross_over()},
            {"figure-2-11", draw_circuits("The circuits that share flow, in each configuration", all)},
            {"figure-b-1", draw_circuits("Branch #1 in configuration a", {{"bucket, boom", branch}})},
            {"figure-a-1", draw_circuits("The boom alone", {{"boom", boom_circuit()}})}};
}

/// The thesis's statement (section 3.3) about a configuration with all links active: the number of searches, and the
/// number of links in the largest search.
struct Said {
    Configuration configuration;
    std::optional<double> searches, links;
};
constexpr std::array said{Said{Configuration::a, 2, 2}, Said{Configuration::b, 2, 3}, Said{Configuration::c, {}, {}},
                          Said{Configuration::d, 1, 4}, Said{Configuration::e, 1, 4}};

Comparison searches_of_configurations() {
    Comparison comparison{.name = "links that one search must find at once (section 3.3), all links active"};
    for (const auto& [configuration, searches, links] : said) {
        std::string column = fmt::format("configuration {}", name_of(configuration));
        std::vector<LinkSet> groups = coupled_groups(configuration);
        std::size_t most = std::ranges::max(groups, {}, &LinkSet::size).size();
        comparison.add(cell_of("searches", column, "", searches, static_cast<double>(groups.size()), 0., 0));
        comparison.add(cell_of("links of the greatest", column, "", links, static_cast<double>(most), 0., 0));
    }
    return comparison;
}

/// Counts the unknown states of branch #1: for each link, the flow into the cylinder, the flow past the cylinder, and
/// the pressure at the junction.
Comparison states_of_branch_1() {
    Comparison comparison{.name = "unknown internal states of branch #1 (appendix B)", .judged = true};
    std::size_t states = 3 * circuit_of(Configuration::a, {Link::bucket, Link::boom}).size();
    comparison.add(judged_cell("Q_BUi, Q_BOi, Q_11, Q_12, P_11, P_12", "configuration a", "", 6,
                               static_cast<double>(states), 0, 0));
    return comparison;
}

Replay replay_circuits(const ReplayContext&) {
    Replay replay = replay_of({searches_of_configurations(), states_of_branch_1()}, {});
    replay.drawings = drawings();
    return replay;
}

} // namespace

extern const Experiment circuits_experiment{
    .name = "circuits",
    .about = "drawings of the main valve's circuits that share flow: Figures 2.11, 2.12, A.1, A.2, B.1",
    .chapter = "2",
    .number = 4,
    .run = replay_circuits,
};

} // namespace placedpar
