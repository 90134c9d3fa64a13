#include "occam/code/workspaces.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace placedpar::occam {

namespace {

constexpr std::size_t most_workspaces = 65'536;

/// Returns whether the component of a PAR is a PAR itself, whose components stand for it.
bool is_only_parallel(const Frame& component) { return component.is_parallel && component.starters() == 1; }

using NameCounts = std::map<std::string, int>;

/// Counts the names of the components that a frame starts, without indices.
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

/// Collects the workspaces of the processes that a frame starts, from the outermost on. A frame that starts processes
/// at several places uses the same words for all of them, so these get no names.
class Workspaces {
public:
    explicit Workspaces(const Frame& first) { add_within(first, 0, {}); }
    std::vector<CodeWorkspace> take() { return std::move(found_); }

private:
    /// What the names of processes consist of.
    struct Naming {
        std::string before = {}, before_inner = {}, indices = {};
        bool is_outermost = true;
        const NameCounts* counts = nullptr; ///< of the components beside each other
    };

    /// Adds what a process starts. `base`: the workspace pointer of its procedure, in words from the first one.
    void add_within(const Frame& frame, std::int64_t base, Naming naming) {
        NameCounts counts;
        count_names(frame, counts);
        naming.counts = &counts;
        add_started(frame, base, naming);
    }

    void add_started(const Frame& frame, std::int64_t base, const Naming& naming) {
        if (frame.starters() != 1)
            return;
        const std::int64_t at = base + frame.coordinate;
        for (const std::vector<Frame*>& components : frame.parallels)
            for (const Frame* each : components)
                add(*each, base, naming);
        for (const Frame::Replication& each : frame.replications)
            add_replicated(each, at, naming);
        for (const Level* called : frame.calls)
            add_started(called->main, at - words_of_call - called->main.words(), naming);
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
        // The pointer moves down from here, to the words of what the process calls.
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

    /// Adds the words of a process without those of the processes that it starts, which were found from `first` on.
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

std::vector<CodeWorkspace> workspaces_of(const Frame& first) { return Workspaces(first).take(); }

} // namespace placedpar::occam
