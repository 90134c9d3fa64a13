#include "explore/compare/comparison.hpp"

#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "explore/runs_at_once.hpp"
#include "explore/stated_vals.hpp"
#include "netlist/print/print.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace placedpar {

namespace {

using Section = StructureDifference::Section;

Network load_silently(const ParsedNetlist& parsed, const Overrides& set) {
    const ProblemRegistry problems = known_problems(0);
    return load_network(parsed, set, known_kinds(problems), [](const std::string&) {});
}

RunReport report_of(const ComparedRun& run, const Network& network, Interruption& interruption) {
    return run_netlist(network, known_problems(run.seed),
                       {.seed = run.seed, .until = run.until, .shuffle = run.shuffle, .interruption = &interruption});
}

/// Returns the sections of a text that print_cfs() wrote, in the order of Section.
std::array<std::string, 4> sections_of(std::string text) {
    std::array<std::string, 4> sections;
    for (std::size_t i = sections.size(); i-- > 1;) {
        const std::size_t begin = text.find(fmt::format("\n/* {} */\n", name_of(static_cast<Section>(i))));
        if (begin == text.npos)
            continue;
        sections[i] = text.substr(begin);
        text.resize(begin);
    }
    sections[0] = std::move(text);
    return sections;
}

/// Returns the placements of processes, without the placements of channels, which have a dot in their port.
std::string without_routes(const std::string& mapping) {
    std::string kept;
    for (std::size_t begin = 0; begin < mapping.size();) {
        const std::size_t end = std::min(mapping.find('\n', begin), mapping.size() - 1) + 1;
        const std::string line = mapping.substr(begin, end - begin);
        const bool is_route = line.starts_with("place ") && line.find('.') < line.find(" on ");
        kept += is_route ? "" : line;
        begin = end;
    }
    return kept;
}

/// Returns the text of network A in which one section comes from network B. If the section is the hardware or the
/// software, the routes of channels are left out, so that they are chosen anew.
std::string with_section_of(const Network& a, const Network& b, Section section) {
    auto sections = sections_of(print_cfs(a));
    const auto index = static_cast<std::size_t>(section);
    sections.at(index) = sections_of(print_cfs(b)).at(index);
    if (section == Section::hardware || section == Section::software)
        sections[2] = without_routes(sections[2]);
    return fmt::format("{}", fmt::join(sections, ""));
}

/// Returns the first line of a refusal's message. print_cfs() may have written the text of network A that was refused.
/// The place at the beginning of the message is then left out, since the user has never seen this text.
std::string first_line_of(const UserError& refused, const std::string& path, bool is_written) {
    const std::string text = unpainted(refused.what());
    const std::string line = text.substr(0, text.find('\n'));
    constexpr std::string_view error = ": error: ";
    const std::size_t message = line.find(error, path.size());
    if (!is_written || !line.starts_with(path + ":") || message == line.npos)
        return line;
    return "this does not fit the rest of A: " + line.substr(message + error.size());
}

class Comparing {
public:
    Comparing(const ComparedRun& a, const ComparedRun& b, const Interruption& interruption,
              const std::function<void(std::size_t, std::size_t)>& progress)
        : a_(a), b_(b), interruption_(interruption), progress_(progress) {}

    NetlistComparison compare() && {
        result_.name_a = a_.name;
        result_.name_b = b_.name;
        result_.a = load_compared(a_);
        result_.b = load_compared(b_);
        run_both();
        find_differences();
        if (result_.both_completed())
            try_changes();
        return std::move(result_);
    }

private:
    /// A run that has yet to be made, and the function that reads its network.
    struct Attempt {
        OneChange* change;
        std::function<Network()> read;
        ComparedRun run;
        bool is_written = true; ///< true: print_cfs() wrote the text of the network
    };

    void run_both() {
        for (RunReport* each : {&result_.report_a, &result_.report_b})
            each->result.ending = Ending::interrupted; // if the interruption comes before the run
        run_at_once(
            2,
            [&](std::size_t i, Interruption& interruption) {
                (i == 0 ? result_.report_a : result_.report_b) =
                    i == 0 ? report_of(a_, result_.a, interruption) : report_of(b_, result_.b, interruption);
            },
            interruption_, [](std::size_t) {});
    }

    void find_differences() {
        const auto vals_b = stated_vals(result_.b);
        for (const auto& [name, value] : stated_vals(result_.a))
            if (auto other = vals_b.find(name); other != vals_b.end() && other->second != value) {
                result_.settings.push_back({name, value, other->second, {}, {{name, other->second}}});
                vals_[name] = other->second;
            }
        result_.structure = structure_differences(result_.a, result_.b);
        with_vals_ = read_with_vals();
        for (SettingDifference& each : setting_differences(*with_vals_, result_.b))
            result_.settings.push_back(std::move(each));
        std::set<Section> left;
        for (const StructureDifference& each : structure_differences(*with_vals_, result_.b))
            left.insert(each.section);
        for (const StructureDifference& each : result_.structure)
            if (!left.contains(each.section))
                result_.following.insert(each.section);
    }

    /// Returns network A with the constants (`val`) of network B. If the netlist of A is refused with these constants,
    /// returns A with its own constants.
    Network read_with_vals() const {
        try {
            return load_silently(a_.parsed, with(vals_));
        } catch (const UserError&) {
            return result_.a;
        }
    }

    Overrides with(Overrides vals) const {
        vals.merge(Overrides(a_.set));
        return vals;
    }

    /// Returns the network with the settings `set`. All other settings are unchanged, because print_cfs() writes them
    /// into the text from which this function reads the network.
    static Network with_settings(const Network& network, const Overrides& set) {
        return load_silently(ParsedNetlist::of_text(print_cfs(network), network.source_path), set);
    }

    /// Returns network A with one section of network B. Elements that are also in A have A's settings, because settings
    /// are compared separately.
    Network with_section(Section section) const {
        const Network swapped = load_silently(
            ParsedNetlist::of_text(with_section_of(result_.a, result_.b, section), result_.a.source_path), {});
        Overrides of_a;
        for (const SettingDifference& each : setting_differences(swapped, result_.a))
            of_a.insert(each.set.begin(), each.set.end());
        return with_settings(swapped, of_a);
    }

    /// Returns the difference without the elements that A lacks. B's constants may declare more elements than A has.
    SettingDifference within_a(const SettingDifference& difference) const {
        const std::set<std::string> known = names_of_elements(result_.a);
        SettingDifference own{difference.name, difference.a, difference.b, {}, {}};
        for (const std::string& element : difference.elements)
            if (known.contains(element)) {
                own.elements.push_back(element);
                own.set[fmt::format("{}.{}", element, own.name)] = own.b;
            }
        return own;
    }

    static std::set<std::string> names_of_elements(const Network& network) {
        std::set<std::string> names;
        std::ranges::transform(network.nodes, std::inserter(names, names.end()), &Node::name);
        std::ranges::transform(network.connections, std::inserter(names, names.end()), &LinkConnection::name);
        std::ranges::transform(network.processes, std::inserter(names, names.end()), &ProcessInstance::name);
        return names;
    }

    void try_changes() {
        std::vector<Attempt> attempts;
        result_.alone.reserve(result_.settings.size() + result_.structure.size() + 3); // attempts point to elements
        for (const SettingDifference& each : result_.settings)
            if (each.elements.empty()) {
                add(attempts, what_of(each), each.set,
                    [this, &each] { return load_silently(a_.parsed, with(each.set)); });
                attempts.back().is_written = false;
            } else if (const SettingDifference own = within_a(each); !own.elements.empty())
                add(attempts, what_of(own), own.set, [this, set = own.set] { return with_settings(result_.a, set); });
        for (const StructureDifference& each : result_.structure)
            if (!result_.following.contains(each.section))
                add(attempts, fmt::format("the {} of B", name_of(each.section)), {},
                    [this, &each] { return with_section(each.section); });
        add_run_settings(attempts);
        if (result_.settings.size() > 1)
            add_together(attempts);
        run(attempts);
    }

    static std::string what_of(const SettingDifference& each) {
        return fmt::format("{}{}: {} in A, {} in B", each.name,
                           each.elements.empty() ? "" : " of " + shown_elements(each.elements), each.a, each.b);
    }

    static std::string shown_elements(const std::vector<std::string>& elements) {
        constexpr std::size_t most = 3;
        const std::size_t shown = std::min(most, elements.size());
        return fmt::format("{}{}",
                           fmt::join(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                           elements.size() > most ? fmt::format(" and {} more", elements.size() - most) : "");
    }

    void add(std::vector<Attempt>& attempts, const std::string& what, const Overrides& set,
             std::function<Network()> read) {
        OneChange& change = result_.alone.emplace_back(OneChange{.what = what, .set = set});
        attempts.push_back({&change, std::move(read), a_});
    }

    /// Adds the settings of the run that differ: seed, time limit and order of ready processes.
    void add_run_settings(std::vector<Attempt>& attempts) {
        auto add_if_other = [&](auto ComparedRun::*setting, const std::string& what) {
            if (a_.*setting == b_.*setting)
                return;
            add(attempts, what, {}, [this] { return result_.a; });
            attempts.back().run.*setting = b_.*setting;
        };
        add_if_other(&ComparedRun::seed, fmt::format("seed: {} in A, {} in B", a_.seed, b_.seed));
        add_if_other(&ComparedRun::until, "the time at which the run is stopped");
        add_if_other(&ComparedRun::shuffle, "the order of ready processes (--shuffle)");
    }

    void add_together(std::vector<Attempt>& attempts) {
        Overrides all;
        for (const SettingDifference& each : result_.settings)
            if (!each.elements.empty())
                all.insert(each.set.begin(), each.set.end());
        result_.together = OneChange{.what = "all settings of B together"};
        attempts.push_back({&*result_.together, [this, all] { return with_settings(*with_vals_, all); }, a_});
    }

    void run(std::vector<Attempt>& attempts) {
        run_at_once(
            attempts.size(), [&](std::size_t i, Interruption& interruption) { run(attempts[i], interruption); },
            interruption_, [&](std::size_t done) { progress_(done, attempts.size()); });
    }

    void run(Attempt& attempt, Interruption& interruption) const {
        try {
            const RunReport report = report_of(attempt.run, attempt.read(), interruption);
            attempt.change->outcome = report.outcome();
            attempt.change->time = report.result.time;
        } catch (const UserError& refused) {
            attempt.change->refused = first_line_of(refused, result_.a.source_path, attempt.is_written);
        }
    }

    const ComparedRun &a_, &b_;
    const Interruption& interruption_;
    const std::function<void(std::size_t, std::size_t)>& progress_;
    NetlistComparison result_;
    Overrides vals_;                   ///< constants (`val`) of B whose values in A differ
    std::optional<Network> with_vals_; ///< A with these constants
};

} // namespace

Network load_compared(const ComparedRun& run) { return load_silently(run.parsed, run.set); }

bool NetlistComparison::both_completed() const {
    return report_a.outcome() == RunOutcome::completed && report_b.outcome() == RunOutcome::completed;
}

NetlistComparison compare_runs(const ComparedRun& a, const ComparedRun& b, const Interruption& interruption,
                               const std::function<void(std::size_t, std::size_t)>& progress) {
    return Comparing(a, b, interruption, progress).compare();
}

} // namespace placedpar
