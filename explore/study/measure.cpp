#include "explore/study/measure.hpp"

#include "explore/problems.hpp"
#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace placedpar {

namespace {

constexpr double picoseconds_in_ms = 1e9;

void add_figure(StudyFigures& figures, const std::string& name, double value, const std::string& unit = "") {
    figures[name] = {std::isfinite(value) ? value : std::nan(""), unit};
}

/// Returns the name of the figure without subscripts: "t.busy" for "t[0][1].busy".
std::string name_of_array(const std::string& figure) {
    std::size_t bracket = figure.find('['), dot = figure.rfind('.');
    return bracket == figure.npos || dot == figure.npos || dot < bracket
               ? figure
               : figure.substr(0, bracket) + figure.substr(dot);
}

std::string unknown_measure(const std::string& measure, const std::set<std::string>& known) {
    std::vector<std::string> names(known.begin(), known.end());
    return unknown_name("measure", measure, names,
                        fmt::format("the runs have the measures {}", fmt::join(names, ", ")));
}

/// Returns the number of these measurements that the kind describes.
std::ptrdiff_t count_described(const ProcessKind& kind, const std::set<std::string>& measured) {
    return std::ranges::count_if(kind.measurements, [&](const auto& each) { return measured.contains(each.name); });
}

/// Returns the description that a process's kind gives of a measurement. The figures do not name the kind. So the kind
/// is assumed that describes the most of the process's other measurements. Returns "" if this kind does not describe
/// the measurement.
std::string description_of(const std::string& name, const std::set<std::string>& measured, const Catalogue& kinds) {
    std::ptrdiff_t most = 1;
    for (const auto& each : kinds.kinds())
        most = std::max(most, count_described(each.second, measured));
    for (const auto& each : kinds.kinds())
        if (count_described(each.second, measured) == most)
            for (const MeasurementDescription& described : each.second.measurements)
                if (described.name == name)
                    return described.about;
    return "";
}

/// Returns the description of a measurement that the process of this name can make, but did not make in this run.
/// Returns "" if the process made the measurement, or if no kind describes it.
std::string not_come_to(const StudyMeasure& measure, const StudyFigures& figures) {
    std::string name = measure.name_without_subscripts(), process = name.substr(0, name.rfind('.') + 1);
    name = name.substr(process.size());
    std::set<std::string> measured;
    for (const auto& each : figures)
        if (std::string figure = name_of_array(each.first); !process.empty() && figure.starts_with(process))
            measured.insert(figure.substr(process.size()));
    const ProblemRegistry problems = known_problems(0); // the kinds refer to it
    return measured.empty() || measured.contains(name) ? "" : description_of(name, measured, known_kinds(problems));
}

/// Returns the numbers of a JSON text outside of its strings. It is needed because Boost.JSON 1.81 reads the last bit
/// of some numbers wrong.
std::vector<double> numbers_outside_of_strings(const std::string& json) {
    std::vector<double> numbers;
    bool quoted = false;
    for (const char *at = json.data(), *end = at + json.size(); at < end; ++at) {
        if (quoted && *at == '\\')
            ++at;
        else if (*at == '"')
            quoted = !quoted;
        else if (double number = 0; !quoted && (*at == '-' || std::isdigit(static_cast<unsigned char>(*at)))) {
            auto [stop, error] = std::from_chars(at, end, number);
            if (error != std::errc())
                throw std::out_of_range("a number is beyond the range of a double");
            numbers.push_back(number);
            at = stop - 1;
        }
    }
    return numbers;
}

} // namespace

StudyFigures figures_of(const RunReport& report, const Network& network, const Prices& prices) {
    StudyFigures figures;
    add_figure(figures, "time", static_cast<double>(report.result.time.count()) / picoseconds_in_ms, "ms");
    add_figure(figures, "processors", static_cast<double>(report.processors.size()));
    add_figure(figures, "links", static_cast<double>(network.count_wires()));
    if (!prices.empty())
        add_figure(figures, "price", price_of(network, prices));
    for (const Measurement& each : report.measurements)
        if (const auto* value = std::get_if<double>(&each.value))
            add_figure(figures, each.process + "." + each.name, *value, each.unit);
    for (const ProcessorUse& each : report.processors)
        if (auto share = report.share(each.busy))
            add_figure(figures, each.name + ".busy", 100 * *share, "%");
    return figures;
}

boost::json::value read_kept_json(const std::string& text) {
    return boost::json::parse(text, {}, {.allow_invalid_utf8 = true});
}

std::string figures_text(const StudyFigures& figures) {
    boost::json::object json;
    for (const auto& [name, figure] : figures)
        json[name] = boost::json::array{
            std::isnan(figure.value) ? boost::json::value() : boost::json::value(figure.value), figure.unit};
    return boost::json::serialize(json);
}

StudyFigures figures_from(const std::string& text) {
    const std::vector<double> numbers = numbers_outside_of_strings(text);
    const boost::json::value json = read_kept_json(text);
    StudyFigures figures;
    std::size_t number = 0;
    for (const auto& [name, value] : json.as_object()) {
        const boost::json::array& figure = value.as_array();
        if (figure.size() != 2 || (!figure[0].is_number() && !figure[0].is_null()))
            throw std::out_of_range("a figure lacks its number or unit");
        const double number_or_none = figure[0].is_null() ? std::nan("") : numbers.at(number++);
        figures[std::string(name)] = {number_or_none, std::string(figure[1].as_string())};
    }
    if (number != numbers.size())
        throw std::out_of_range("a figure occurs twice");
    return figures;
}

StudyMeasure::StudyMeasure(const std::string& text) : text_(text), name_(text) {
    constexpr std::array<std::pair<const char*, Aggregate>, 4> ways{{{"mean(", Aggregate::mean},
                                                                     {"min(", Aggregate::least},
                                                                     {"max(", Aggregate::greatest},
                                                                     {"sum(", Aggregate::sum}}};
    for (const auto& [word, way] : ways)
        if (text.starts_with(word) && text.ends_with(')')) {
            way_ = way;
            name_ = text.substr(std::string(word).size());
            name_.pop_back();
        }
    if (name_.empty() || name_.find_first_of("(),") != name_.npos)
        throw UserError(
            fmt::format("\"{}\" is not a measure: expected time, PROCESS.NAME, or its min, max, mean or sum over "
                        "an array of processes, such as master.T_exe or max(master.T_exe)",
                        text));
}

bool StudyMeasure::matches(const std::string& figure) const {
    return figure == name_ || name_of_array(figure) == name_;
}

bool StudyMeasure::is_in(const StudyFigures& figures) const {
    return std::ranges::any_of(figures, [this](const auto& each) { return matches(each.first); });
}

std::optional<StudyFigure> StudyMeasure::of(const StudyFigures& figures) const {
    std::vector<double> values;
    std::string unit;
    bool all_are_numbers = true;
    for (const auto& [name, figure] : figures)
        if (matches(name)) {
            unit = figure.unit;
            if (std::isnan(figure.value))
                all_are_numbers = false;
            else
                values.push_back(figure.value);
        }
    const bool needs_all = way_ == Aggregate::mean || way_ == Aggregate::sum;
    if (values.empty() || (needs_all && !all_are_numbers))
        return std::nullopt;
    double sum = 0;
    for (double value : values)
        sum += value;
    switch (way_) {
    case Aggregate::mean: return StudyFigure{sum / static_cast<double>(values.size()), unit};
    case Aggregate::least: return StudyFigure{std::ranges::min(values), unit};
    case Aggregate::greatest: return StudyFigure{std::ranges::max(values), unit};
    case Aggregate::sum: break;
    }
    return StudyFigure{sum, unit};
}

std::string StudyMeasure::name_without_subscripts() const { return name_of_array(name_); }

std::string StudyMeasure::last_name() const {
    const std::string name = name_without_subscripts();
    return name.substr(name.rfind('.') + 1); // the whole name if there is no dot
}

std::string there_is_no_measure(const StudyMeasure& measure, const StudyFigures& figures) {
    if (measure.is_in(figures))
        return fmt::format("a run measured no number as \"{}\"", measure.text());
    if (std::string about = not_come_to(measure, figures); !about.empty())
        return fmt::format("no run measured \"{}\": {}", measure.text(), about);
    std::set<std::string> names;
    for (const auto& each : figures)
        names.insert(name_of_array(each.first));
    return unknown_measure(measure.text(), names);
}

void PossibleMeasures::add(const Network& network, const Catalogue& kinds, const ProblemRegistry& problems) {
    abouts_["time"] = "length of the run in ms";
    abouts_["processors"] = "number of processors in the machine";
    abouts_["links"] = "number of wires in the machine";
    for (const Node& node : network.nodes)
        abouts_[name_of_array(node.name + ".busy")] = "load of the processor in %";
    for (const ProcessInstance& process : network.processes) {
        const ProcessKind* kind = kinds.find(process.kind);
        if (!kind || kind->measurements.empty())
            unknown_.insert(name_of_array(process.name + "."));
        else
            for (const MeasurementDescription& each : kind->measurements)
                add(process, each, problems);
    }
}

/// Adds the measures of a process. If the names of measures depend on the process, the kind describes them in words,
/// such as "the problem's parameters".
void PossibleMeasures::add(const ProcessInstance& process, const MeasurementDescription& described,
                           const ProblemRegistry& problems) {
    auto problem = process.parameters.find("problem");
    const std::string about = described.about + (described.unit.empty() ? "" : " in " + described.unit);
    if (described.name.find(' ') == described.name.npos)
        abouts_[name_of_array(process.name + "." + described.name)] = about;
    else if (problem == process.parameters.end())
        unknown_.insert(name_of_array(process.name + "."));
    else
        for (const std::string& each :
             problems.find(std::get<std::string>(problem->second)).problem()->parameter_names())
            abouts_[name_of_array(process.name + "." + each)] = about;
}

bool PossibleMeasures::has(const StudyMeasure& measure) const {
    std::string name = measure.name_without_subscripts();
    return abouts_.contains(name) || unknown_.contains(name.substr(0, name.rfind('.') + 1));
}

std::string PossibleMeasures::why_unknown(const StudyMeasure& measure) const {
    std::set<std::string> names;
    for (const auto& each : abouts_)
        names.insert(each.first);
    return unknown_measure(measure.name_without_subscripts(), names);
}

} // namespace placedpar
