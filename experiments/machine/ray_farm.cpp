#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "explore/workers.hpp"
#include "runtime/alternation.hpp"
#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/simulation.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <list>
#include <string>
#include <vector>

namespace placedpar {

namespace {

using hardware::Memory;
using hardware::Processor;
using hardware::Router;
using hardware::RouterCosts;
using hardware::RouterLink;

/// A message of the farm's protocol. occam outputs each part of `out ! tag; x; y` as a separate message.
struct FarmWords {
    enum class Tag : std::int8_t { stop, render, patch, note, data } tag = Tag::data;
    std::uint32_t words = 1;
    WireForm wire_form() const { return WireForm(4 * words); }
};
using FarmTag = FarmWords::Tag;
using FarmChannel = Channel<FarmWords>;

void send_tagged(FarmChannel& out, FarmTag tag, int words) {
    out.out().output({tag});
    for (int i = 0; i < words; ++i)
        out.out().output({});
}

FarmTag take_tag(FarmChannel& in) { return in.in().input().tag; }

void take_words(FarmChannel& in, int messages) {
    for (int i = 0; i < messages; ++i)
        in.in().input();
}

/// A patch of 8 x 8 pixels is sent as its position and size, followed by the pixels, row by row, with one word for each
/// pixel. A task consists only of a position.
constexpr int patch_edge = 8, patch_head = 3, task_head = 2, patches_of_image = 256 / patch_edge * 256 / patch_edge;

/// Passes on a patch whose tag has already been input.
void pass_patch(FarmChannel& in, FarmChannel& out) {
    take_words(in, patch_head);
    send_tagged(out, FarmTag::patch, patch_head);
    for (int i = 0; i < patch_edge; ++i)
        out.out().output(in.in().input());
}

/// Passes patches on until the tag `stop` arrives, which is also passed on.
void buffer_patches(FarmChannel& in, FarmChannel& out) {
    while (take_tag(in) == FarmTag::patch)
        pass_patch(in, out);
    send_tagged(out, FarmTag::stop, 0);
}

struct RayFarmSettings {
    std::size_t workers;
    RouterCosts router;
};

/// The farm that renders an image on its machine of transputers. The processes form a line of workers, but the links
/// form a tree. Neighbours in the line may be twenty links apart, so all their messages are sent in packets.
class RayFarm {
public:
    /// The costs of rendering a patch and of passing on a packet. Both costs are calibrated to the published times with
    /// 11 workers and with 71 workers.
    static constexpr Cycles patch{138'500'000}, packet{4500};

    explicit RayFarm(const RayFarmSettings& settings) : settings_(settings) {
        build_machine();
        FarmChannel* from_before = &channel(1, 2);
        FarmChannel* to_before = &channel(2, 1);
        build_control(*from_before, *to_before);
        for (std::size_t node = 2; node < settings.workers + 2; ++node) {
            const bool last = node == settings.workers + 1;
            FarmChannel& onward = last ? soft() : channel(node, node + 1); // the last worker sends the tag `stop` to
                                                                           // itself
            FarmChannel& back = last ? onward : channel(node + 1, node);
            build_worker(*processors_[node], {*from_before, *to_before, onward, back});
            from_before = &onward;
            to_before = &back;
        }
    }

    RunResult run() {
        RunResult result = simulation_.run();
        result.time = done_;
        return result;
    }

private:
    struct WorkerChannels {
        FarmChannel &from_before, &to_before, &onward, &back;
    };

    /// Returns the parent of a processor in the tree: the first neighbour with a lower number, in the order of the list
    /// of links of 2 May 2022. Since 2023, the program that makes the network's description has used one link per
    /// processor.
    std::size_t parent(std::size_t node) const {
        static constexpr std::array<std::uint8_t, 13> two_cards{0, 0, 1, 2, 3, 4, 5, 1, 2, 3, 4, 5, 6};
        static constexpr std::array<std::uint8_t, 73> rack{
            0,  0,  0,  1,  1,  1,  2,  2,  2,  3,  3,  3,  5,  5,  8,  7,  7,  7,  8,  9,  9,  11, 12, 13, 13,
            14, 17, 16, 16, 17, 18, 18, 18, 20, 21, 22, 22, 22, 23, 24, 29, 37, 25, 25, 28, 29, 32, 30, 30, 31,
            32, 35, 34, 42, 35, 35, 40, 46, 48, 48, 49, 58, 61, 59, 51, 52, 54, 64, 64, 65, 67, 70, 68};
        return settings_.workers + 2 == two_cards.size() ? two_cards.at(node) : rack.at(node);
    }

    void build_machine() {
        constexpr std::int64_t clock = 25'000'000; // "T425c-25" in the list of processors
        for (std::size_t node = 0; node < settings_.workers + 2; ++node) {
            processors_.push_back(&simulation_.add<Processor>(fmt::format("t{}", node), clock, Cycles{0},
                                                              Memory{.access = Memory::outside}));
            routers_.push_back(&simulation_.add<Router>(processors_.back(), settings_.router));
            if (node > 0)
                up_.push_back(&link_between(node, parent(node)));
        }
    }
    RouterLink& link_between(std::size_t a, std::size_t b) {
        auto& link = simulation_.add<hardware::Link>();
        processors_[a]->has_link(link);
        processors_[b]->has_link(link);
        return simulation_.add<RouterLink>(link, *routers_[a], *routers_[b]);
    }
    RouterLink& link_up(std::size_t node) { return *up_[node - 1]; }

    FarmChannel& soft() { return channels_.emplace_back(fmt::format("c{}", channels_.size())); }
    /// Returns a channel through the tree, up from one processor and down to the other.
    FarmChannel& channel(std::size_t from, std::size_t to) {
        std::vector<hardware::Hop> way;
        std::vector<std::size_t> down;
        while (from != to)
            if (from > to) {
                way.push_back({link_up(from), true});
                from = parent(from);
            } else {
                down.push_back(to);
                to = parent(to);
            }
        for (; !down.empty(); down.pop_back())
            way.push_back({link_up(down.back()), false});
        FarmChannel& made = soft();
        made.put_on(simulation_.add<hardware::Route>(way));
        return made;
    }

    /// Adds the controlling processes, which deal out tasks and pass the results on. Each worker has at most two
    /// unfinished tasks.
    void build_control(FarmChannel& to_workers, FarmChannel& from_workers) {
        FarmChannel &tasks = soft(), &dealt = soft(), &done = soft(), &graphics = channel(1, 0);
        Processor* control = processors_[1];
        simulation_.process(
            "tasks",
            [&tasks] {
                for (int i = 0; i < patches_of_image; ++i)
                    send_tagged(tasks, FarmTag::render, task_head);
                send_tagged(tasks, FarmTag::stop, 0);
            },
            control);
        simulation_.process(
            "output buffer",
            [&dealt, &to_workers] {
                while (take_tag(dealt) == FarmTag::render)
                    take_words(dealt, task_head), send_tagged(to_workers, FarmTag::render, task_head);
                send_tagged(to_workers, FarmTag::stop, 0);
            },
            control);
        simulation_.process(
            "return buffer", [&] { buffer_patches(from_workers, done); }, control);
        simulation_.process(
            "balancer", [this, &tasks, &dealt, &done, &graphics] { balance(tasks, dealt, done, graphics); }, control);
        simulation_.process(
            "frame", [this, &graphics] { take_image(graphics); }, processors_[0], Priority::high);
    }
    /// Sends a text for the screen: first the length of the text, then a word for each character.
    static void write(FarmChannel& graphics, std::uint32_t characters) {
        send_tagged(graphics, FarmTag::note, 1);
        graphics.out().output({FarmTag::data, characters});
    }
    void balance(FarmChannel& tasks, FarmChannel& dealt, FarmChannel& done, FarmChannel& graphics) const {
        constexpr std::uint32_t task_note = 24, patch_note = 11;
        std::size_t free = 2 * settings_.workers;
        bool dealing = true, collecting = true;
        auto deal = [&](const FarmWords& word) {
            dealing = word.tag == FarmTag::render;
            if (!dealing)
                return send_tagged(dealt, FarmTag::stop, 0);
            write(graphics, task_note);
            take_words(tasks, task_head);
            send_tagged(dealt, FarmTag::render, task_head);
            --free;
        };
        auto collect = [&](const FarmWords& word) {
            collecting = word.tag == FarmTag::patch;
            if (!collecting)
                return;
            write(graphics, patch_note);
            pass_patch(done, graphics);
            ++free;
        };
        while (dealing || collecting)
            alt(when(dealing && free > 0, on(tasks.in(), deal)), on(done.in(), collect));
        send_tagged(graphics, FarmTag::stop, 0);
    }
    void take_image(FarmChannel& graphics) {
        for (FarmTag tag = take_tag(graphics); tag != FarmTag::stop; tag = take_tag(graphics))
            take_words(graphics, tag == FarmTag::patch ? patch_head + patch_edge : 2);
        done_ = now();
    }

    /// Adds a worker, which consists of four processes of high priority that pass on tasks and patches, and of a
    /// renderer of low priority.
    void build_worker(Processor& processor, const WorkerChannels& at) {
        FarmChannel &feed = soft(), &idle = soft(), &own = soft(), &mixed_own = soft(), &mixed_back = soft();
        auto add = [&](const char* name, Process::Body body, Priority priority) {
            simulation_.process(processor.name() + name, std::move(body), &processor, priority);
        };
        add(
            " tasks", [at, &feed, &idle] { pass_tasks(at.from_before, at.onward, feed, idle); }, Priority::high);
        add(
            " back", [at, &mixed_back] { buffer_patches(at.back, mixed_back); }, Priority::high);
        add(
            " own", [&own, &mixed_own] { buffer_patches(own, mixed_own); }, Priority::high);
        add(
            " mix", [at, &mixed_back, &mixed_own] { mix(mixed_back, mixed_own, at.to_before); }, Priority::high);
        add(
            " renderer", [&feed, &own, &idle] { render(feed, own, idle); }, Priority::low);
    }
    /// Keeps one task in addition to the task that is being rendered, and passes other tasks on.
    static void pass_tasks(FarmChannel& from_before, FarmChannel& onward, FarmChannel& feed, FarmChannel& idle) {
        int held = 0; // tasks kept, including the task being rendered
        bool open = true;
        auto give = [&feed] { send_tagged(feed, FarmTag::render, task_head); };
        auto rendered = [&](const FarmWords&) {
            if (--held > 0)
                give();
        };
        auto take = [&](const FarmWords& word) {
            open = word.tag == FarmTag::render;
            if (!open)
                return;
            take_words(from_before, task_head);
            if (held == 2)
                return send_tagged(onward, FarmTag::render, task_head);
            if (++held == 1)
                give();
        };
        while (open)
            alt(on(idle.in(), rendered), on(from_before.in(), take));
        while (held > 0)
            rendered(idle.in().input());
        send_tagged(feed, FarmTag::stop, 0);
        send_tagged(onward, FarmTag::stop, 0);
    }
    static void mix(FarmChannel& back, FarmChannel& own, FarmChannel& out) {
        int open = 2;
        auto take = [&](FarmChannel& in) {
            return on(in.in(), [&](const FarmWords& word) {
                if (word.tag == FarmTag::patch)
                    pass_patch(in, out);
                else
                    --open;
            });
        };
        while (open > 0)
            alt(take(back), take(own));
        send_tagged(out, FarmTag::stop, 0);
    }
    static void render(FarmChannel& feed, FarmChannel& own, FarmChannel& idle) {
        constexpr Cycles loop{100}; // chosen here: cycles from one descheduling point to the next
        while (take_tag(feed) == FarmTag::render) {
            take_words(feed, task_head);
            compute(patch, {.between_points = loop});
            send_tagged(own, FarmTag::patch, patch_head);
            for (int i = 0; i < patch_edge; ++i)
                own.out().output({FarmTag::data, patch_edge});
            idle.out().output({});
        }
        send_tagged(own, FarmTag::stop, 0);
    }

    RayFarmSettings settings_;
    Simulation simulation_;
    std::vector<Processor*> processors_;
    std::vector<Router*> routers_;
    std::vector<RouterLink*> up_;
    std::list<FarmChannel> channels_;
    Time done_{};
};

struct RayFarmRun {
    RayFarmSettings settings;
    const char* router;
    double published_s;
    Origin origin = Origin::outcome;
    std::optional<double> tolerance_percent = {};
    RunResult result = {};
};

std::vector<RayFarmRun> ray_farm_runs() {
    constexpr RouterCosts usual{}, low{.priority = Priority::low}, slow{.handling = RayFarm::packet};
    constexpr const char *high_name = "high", *low_name = "low", *slow_name = "high, 4500 cycles a packet";
    using enum Origin;
    return {{{71, usual}, high_name, 160},
            {{11, low}, low_name, 532},
            {{35, low}, low_name, 184},
            {{71, low}, low_name, 160},
            {{11, slow}, slow_name, 532, calibrated, 1},
            {{17, slow}, slow_name, 333, outcome, 12},
            {{35, slow}, slow_name, 184, outcome, 12},
            {{53, slow}, slow_name, 165, outcome, 12},
            {{71, slow}, slow_name, 160, calibrated, 2}};
}

std::vector<hardware::Constant> constants_of_ray_farm() {
    constexpr std::string_view group = "ray tracer under INMOS's virtual router";
    auto cycles = [](Cycles each) { return static_cast<double>(each); };
    return {{group, "a patch of 8 x 8 pixels", cycles(RayFarm::patch) * 1e-6, "Mcycles",
             hardware::Provenance::calibrated, "532 s with 11 workers"},
            {group, "a packet sent, or received", cycles(RayFarm::packet), "cycles", hardware::Provenance::calibrated,
             "160 s with 71 workers"}};
}

Cell farm_cell(const RayFarmRun& run) {
    return {.row = fmt::format("farm of {} workers, routers {}", run.settings.workers, run.router),
            .column = "time",
            .unit = "s",
            .reference = run.published_s,
            .simulated = in_milliseconds(run.result.time) / 1000,
            .tolerance_percent = run.tolerance_percent,
            .origin = run.origin,
            .decimals = 0,
            .source = "ray tracer under INMOS's virtual router (machineroom/oc-ray)"};
}

Replay replay_ray_farm(const ReplayContext& context) {
    std::vector<RayFarmRun> runs = ray_farm_runs();
    std::atomic<std::size_t> next = 0, ended = 0;
    on_workers(
        count_cores(),
        [&](std::size_t) {
            for (std::size_t i = next++; i < runs.size(); i = next++) {
                RayFarmRun& run = runs[runs.size() - 1 - i]; // the longest run first
                run.result = RayFarm(run.settings).run();
                ++ended;
            }
        },
        [&] { context.progress(fmt::format("{} of {} runs of a farm", ended.load(), runs.size())); });
    Comparison comparison{
        .name = "a farm on 73 transputers",
        .notes =
            "The real program printed at its host for each patch. This is not simulated, so the calibrated cycles of\n"
            "a packet may include it. It is not known which cards worked in the runs with 17, 35 and 53 workers.\n",
        .against = "publ.",
        .judged = true,
        .names_origins = true};
    Fingerprint fingerprint;
    for (const RayFarmRun& run : runs) {
        comparison.add(farm_cell(run));
        fingerprint.mix(run.result.fingerprint);
    }
    Replay replay{.comparisons = {comparison}};
    replay.constant_table = constants_of_ray_farm();
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace

extern const Experiment ray_farm_experiment{
    .name = "ray-farm",
    .about = "a farm with routed channels on 73 transputers, compared with published times",
    .chapter = "machine",
    .number = 4,
    .run = replay_ray_farm,
};

} // namespace placedpar
