#include "identification/report/diagnosis_report.hpp"

#include "identification/report/compliance_text.hpp"
#include "text/counted.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// Blanks in place of the times. Only the first line of a movement shows the times.
constexpr std::string_view no_times = "                       ";

std::string print_finding(const LinkFinding& link) {
    if (!link.compliance_in3_per_psi)
        return fmt::format("C_{}i     -", symbol_of(link.link));
    return print_compliance(fmt::format("C_{}i", symbol_of(link.link)), *link.compliance_in3_per_psi,
                            link.standard_error_in3_per_psi);
}

/// Returns whether the deviation includes an offset, which directly measured areas do not have.
bool knows_offset(const Deviation& deviation) { return deviation.by[index_of(FaultHypothesis::offset)] != 0; }

std::string with_error(const Deviation& deviation, FaultHypothesis way, double unit) {
    if (!std::isfinite(deviation.standard_error(way)))
        return "-";
    return fmt::format("{:+.4f} +- {:.4f}", unit * deviation.by[index_of(way)], unit * deviation.standard_error(way));
}

std::string print_offset(const WholeMovement& whole) {
    if (!knows_offset(whole.deviation))
        return "";
    return fmt::format(", spool {} in", with_error(whole.deviation, FaultHypothesis::offset, whole.units.offset_in));
}

double compliance_error(const WholeMovement& whole) {
    return whole.units.compliance_in3_per_psi * whole.deviation.standard_error(FaultHypothesis::compliance);
}

/// Returns the result for the whole movement. This line stands below the result of the search.
std::string print_whole(const WholeMovement& whole) {
    return fmt::format("{}{}  leak {} in^3/(s psi){}\n", no_times,
                       print_compliance("  whole", whole.compliance_in3_per_psi, compliance_error(whole)),
                       with_error(whole.deviation, FaultHypothesis::leak, whole.units.leak_in3_per_s_psi),
                       print_offset(whole));
}

double by(const Verdict& verdict, FaultHypothesis way) { return verdict.deviation.by[index_of(way)]; }

/// Returns the link's deviation for each hypothesis.
std::string print_deviation(const LinkVerdict& link) {
    auto with_error = [&](FaultHypothesis way, double unit, int decimals) {
        return fmt::format("{:+.{}f} (standard error {:.{}f})", unit * by(link.verdict, way), decimals,
                           unit * link.verdict.deviation.standard_error(way), decimals);
    };
    const std::string offset =
        knows_offset(link.verdict.deviation)
            ? fmt::format(", spool {} in", with_error(FaultHypothesis::offset, link.units.offset_in, 4))
            : "";
    return fmt::format("compliance {} in^3/psi, leak {} in^3/(s psi){}",
                       with_error(FaultHypothesis::compliance, link.units.compliance_in3_per_psi, 5),
                       with_error(FaultHypothesis::leak, link.units.leak_in3_per_s_psi, 4), offset);
}

std::string print_verdict(Link link, const LinkVerdict& said) {
    const Verdict& verdict = said.verdict;
    if (verdict.kind == VerdictKind::sound)
        return fmt::format(
            "{}: sound, {}, from its last {}; deviations: {}\n", name_of(link), how_sure(verdict.probability),
            verdict.movements == 1 ? "movement" : counted(verdict.movements, "movement"), print_deviation(said));
    if (verdict.kind == VerdictKind::cannot_tell)
        return fmt::format("{}: cannot tell from its last {} whether the link is sound; deviations: {}\n",
                           name_of(link), verdict.movements == 1 ? "movement" : counted(verdict.movements, "movement"),
                           print_deviation(said));
    if (verdict.kind == VerdictKind::not_enough_evidence)
        return fmt::format("{}: not enough evidence: the first {} movements set the baseline; after that, one movement "
                           "can show that the link is sound, and two can show a fault\n",
                           name_of(link), LinkJudge::movements_of_baseline);
    return "";
}

boost::json::object off_json(const Deviation& deviation, FaultHypothesis way, double unit) {
    return {{"by", or_null(unit * deviation.by[index_of(way)])},
            {"standard_error", or_null(unit * deviation.standard_error(way))}};
}

boost::json::value offset_json(const Deviation& deviation, const WayUnits& units) {
    if (!knows_offset(deviation))
        return nullptr;
    return off_json(deviation, FaultHypothesis::offset, units.offset_in);
}

boost::json::object whole_json(const WholeMovement& whole) {
    return {{"compliance", or_null(whole.compliance_in3_per_psi)},
            {"standard_error", or_null(compliance_error(whole))},
            {"leak_in3_per_s_psi", off_json(whole.deviation, FaultHypothesis::leak, whole.units.leak_in3_per_s_psi)},
            {"offset_in", offset_json(whole.deviation, whole.units)}};
}

boost::json::object finding_json(const LinkFinding& link) {
    const bool known = link.compliance_in3_per_psi.has_value();
    return {{"link", name_of(link.link)},
            {"whole_movement", link.whole ? boost::json::value(whole_json(*link.whole)) : nullptr},
            {"unit", "in^3/psi"},
            {"compliance", or_null(link.compliance_in3_per_psi)},
            {"standard_error", known ? or_null(link.standard_error_in3_per_psi) : nullptr},
            {"lowest", known ? or_null(link.spread_in3_per_psi.first) : nullptr},
            {"highest", known ? or_null(link.spread_in3_per_psi.second) : nullptr},
            {"flags", flags_json(link.flags)}};
}

boost::json::array names_of(LinkSet links) {
    boost::json::array names;
    for (Link link : links_of(links))
        names.emplace_back(name_of(link));
    return names;
}

boost::json::object alarm_json(const Alarm& alarm) {
    return {{"alarm", name_of(alarm.kind)}, {"links", names_of(alarm.links)}, {"text", alarm.text}};
}

boost::json::object verdict_json(Link link, const Diagnosis& diagnosis) {
    const LinkVerdict said = diagnosis.verdict(link);
    return {
        {"link", name_of(link)},
        {"verdict", name_of(said.verdict.kind)},
        {"probability", said.verdict.probability},
        {"movements", said.verdict.movements},
        {"baseline_in3_per_psi", diagnosis.baseline_in3_per_psi(link)},
        {"compliance_in3_per_psi",
         off_json(said.verdict.deviation, FaultHypothesis::compliance, said.units.compliance_in3_per_psi)},
        {"leak_in3_per_s_psi", off_json(said.verdict.deviation, FaultHypothesis::leak, said.units.leak_in3_per_s_psi)},
        {"offset_in", offset_json(said.verdict.deviation, said.units)}};
}

} // namespace

std::string movements_heading() { return fmt::format("     from       to    {}\n", compliance_heading()); }

std::string print_movement(const MovementFinding& movement) {
    std::string text, times = fmt::format("{:9.3f} {:9.3f} s  ", movement.from_s, movement.to_s);
    for (const LinkFinding& link : movement.links) {
        text += fmt::format("{}{}\n{}", times, print_finding(link), link.whole ? print_whole(*link.whole) : "");
        times = no_times;
    }
    for (const LinkFinding& link : movement.links)
        text += print_flags(fmt::format("C_{}i", symbol_of(link.link)), link.flags);
    return text;
}

std::string print_verdicts(const Diagnosis& diagnosis) {
    std::string text;
    for (Link link : links_of(diagnosis.active()))
        text += print_verdict(link, diagnosis.verdict(link));
    for (const Alarm& alarm : diagnosis.alarms())
        text += fmt::format("{}: {}\n", name_of(alarm.kind), alarm.text);
    return text;
}

boost::json::object movement_json(const MovementFinding& movement) {
    boost::json::array links;
    for (const LinkFinding& link : movement.links)
        links.push_back(finding_json(link));
    return {{"set", name_of_set(movement.set)},
            {"from_s", movement.from_s},
            {"to_s", movement.to_s},
            {"links", std::move(links)}};
}

boost::json::object verdicts_json(const Diagnosis& diagnosis) {
    boost::json::array links, alarms;
    for (Link link : links_of(diagnosis.active()))
        links.push_back(verdict_json(link, diagnosis));
    for (const Alarm& alarm : diagnosis.alarms())
        alarms.push_back(alarm_json(alarm));
    return {{"verdicts", std::move(links)}, {"alarms", std::move(alarms)}};
}

} // namespace placedpar
