#include "occam/code/workspaces.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace placedpar::occam {

namespace {

constexpr std::size_t most_workspaces = 65'536;

/// Returns whether a component of a PAR is itself only a PAR. In its place, the components of this inner PAR are
/// listed.
bool is_only_parallel(const Frame& component) { return component.is_parallel && component.starters() == 1; }

using NameCounts = std::map<std::string, int>;

/// Counts for each name, without indices, the components with this name that a frame (the workspace of a process)
/// starts.
void count_names(const Frame& frame, NameCounts& counts);
void count_name(const Frame& component, NameCounts& counts) {
    if (is_only_parallel(component))
        count_names(component, counts);
    else
        ++counts[component.name];
}
void count_names(const Frame& frame, NameCounts& counts) {
    for (const std::vector<Frame*>& components : frame.parallels)
        for (const Frame* each : components)
            count_name(*each, counts);
    for (const Frame::Replication& each : frame.replications)
        count_name(each.level->main, counts);
    for (const Level* each : frame.calls)
        count_names(each->main, counts);
}

/// Adds a name to a list of names such as "reader or writer".
void add_name(std::string& names, const std::string& name) {
    constexpr std::size_t longest = 60;
    constexpr const char* others = " or others";
    if (names.empty() || names == name)
        names = name;
    else if (!names.ends_with(others))
        names += names.size() + name.size() > longest ? others : " or " + name;
}

/// Collects the workspaces of all processes that a process starts, directly or through other processes. If a process
/// executes several PARs, one after the other, their components may use the same words. The workspace with these words
/// then has the names of all these components.
class Workspaces {
public:
    Workspaces(const Frame& first, const std::string& name) {
        add_within(first, 0, {});
        add_rest({-first.below, 1, name, {}, CodeWorkspace::first_process}, 0);
    }
    std::vector<CodeWorkspace> take() { return std::move(found_); }

private:
    /// Holds the parts from which the names of processes are composed.
    struct Naming {
        std::string before = {}, before_inner = {}, indices = {};
        bool is_outermost = true;
        const NameCounts* counts =
            nullptr; ///< for each name: number of components with this name that one process starts
    };

    /// Adds the processes that a process starts. `base` is the workspace pointer of its procedure, in words from the
    /// first workspace pointer of the program.
    void add_within(const Frame& frame, std::int64_t base, Naming naming) {
        NameCounts counts;
        count_names(frame, counts);
        naming.counts = &counts;
        add_started(frame, base, naming);
    }

    void add_started(const Frame& frame, std::int64_t base, const Naming& naming) {
        const std::size_t first = found_.size();
        const std::int64_t at = base + frame.coordinate;
        for (const std::vector<Frame*>& components : frame.parallels)
            for (const Frame* each : components)
                add(*each, base, naming);
        for (const Frame::Replication& each : frame.replications)
            add_replicated(each, at, naming);
        for (const Level* called : frame.calls)
            add_started(called->main, at - words_of_call - called->main.words(), naming);
        if (frame.starters() > 1)
            join_from(first);
    }

    /// Replaces workspaces that have words in common, among those from index `first` on, by workspaces that do not
    /// overlap.
    void join_from(std::size_t first) {
        const std::vector<CodeWorkspace> all(found_.begin() + static_cast<std::ptrdiff_t>(first), found_.end());
        found_.resize(first);
        std::map<std::int64_t, std::vector<std::size_t>>
            bounds; // for each word: the workspaces that begin or end there
        for (std::size_t i = 0; i < all.size(); ++i) {
            bounds[all[i].from].push_back(i);
            bounds[all[i].until].push_back(i);
        }
        std::set<std::size_t> now;
        std::int64_t from = 0;
        for (const auto& [at, changes] : bounds) {
            add_joined(all, now, from, at);
            for (const std::size_t each : changes)
                if (!now.insert(each).second)
                    now.erase(each);
            from = at;
        }
    }

    void add_joined(const std::vector<CodeWorkspace>& all, const std::set<std::size_t>& which, std::int64_t from,
                    std::int64_t until) {
        if (which.empty())
            return;
        CodeWorkspace joined = all[*which.begin()];
        joined.from = from;
        joined.until = until;
        if (which.size() > 1)
            joined.entry = joined.name = joined.inner = "";
        for (const std::size_t each : which) {
            add_name(joined.name, all[each].name);
            add_name(joined.inner, all[each].inner);
        }
        found_.push_back(joined);
    }

    void add_replicated(const Frame::Replication& replication, std::int64_t at, const Naming& naming) {
        const Frame& component = replication.level->main;
        std::int64_t base = at - words_of_scheduler - component.words();
        for (std::int64_t i = 0; i < replication.components && found_.size() < most_workspaces; ++i) {
            Naming with_index = naming;
            with_index.indices +=
                replication.base ? "[" + std::to_string(*replication.base + i) + "]" : "[+" + std::to_string(i) + "]";
            add(component, base, with_index);
            base -= component.words() + component.below;
        }
    }

    void add(const Frame& component, std::int64_t base, const Naming& naming) {
        if (is_only_parallel(component))
            return add_started(component, base, naming);
        const std::int64_t at = base + component.coordinate;
        const bool is_one_of_several = naming.counts->at(component.name) > 1;
        const std::string name = component.name + naming.indices + (is_one_of_several ? " " + component.place : "");
        // `at` is the workspace pointer of the process; the words of procedures that it calls are below.
        const CodeWorkspace own{at - component.below + 1,
                                at + 1,
                                naming.before + name,
                                naming.is_outermost ? "" : naming.before_inner + name,
                                outermost_,
                                component.entry};
        Naming within = naming;
        within.is_outermost = false;
        if (component.is_instance) {
            within.before = own.name + "/";
            within.before_inner = own.inner.empty() ? "" : own.inner + "/";
            within.indices = "";
        }
        const std::size_t first = found_.size();
        add_within(component, base, within);
        add_rest(own, first);
        outermost_ += naming.is_outermost;
    }

    /// Adds the workspace of a process, without the words of the processes that it starts. The latter are in found_,
    /// from index `first` on.
    void add_rest(CodeWorkspace own, std::size_t first) {
        std::vector<std::pair<std::int64_t, std::int64_t>> taken;
        for (std::size_t i = first; i < found_.size(); ++i)
            taken.emplace_back(found_[i].from, found_[i].until);
        std::ranges::sort(taken);
        taken.emplace_back(own.until, own.until);
        const std::int64_t until = own.until;
        for (const auto& [from, end] : taken) {
            own.until = std::min(from, until);
            if (own.from < own.until)
                found_.push_back(own);
            own.from = end;
        }
    }

    std::vector<CodeWorkspace> found_;
    std::size_t outermost_ = 0;
};

} // namespace

std::vector<CodeWorkspace> workspaces_of(const Frame& first, const std::string& name) {
    return Workspaces(first, name).take();
}

} // namespace placedpar::occam
