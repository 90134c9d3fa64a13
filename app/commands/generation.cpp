#include "app/command.hpp"
#include "app/generation/generation_walk.hpp"
#include "app/options/common_options.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

struct GenerationOptions {
    WalkSettings walk;
    std::size_t generations = 1;
    std::string frames;
};

void require_folder_for_frames(const std::filesystem::path& folder) {
    if (is_standard_stream(folder))
        throw UserError("--frames -: frames are written as files into a folder, not to standard output; name a "
                        "folder");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    require_writable(folder / "frame.svg");
}

using Steps = std::vector<DrawnHypercube>;

void write_frame(const std::filesystem::path& path, const std::string& title, const Steps& steps) {
    write_whole(path, draw_hypercubes(title, steps, 2, walk_legend()));
}

void write_single_frames(const std::filesystem::path& folder, const std::string& name, const Steps& steps) {
    for (std::size_t step = 0; step < steps.size(); ++step)
        write_frame(folder / fmt::format("{}-step-{}.svg", name, step), "", {steps[step]});
}

std::string frames_line(const std::string& path) {
    return fmt::format("frames: {0}-step-*.svg; all frames in one file: {0}.svg\n", path);
}

/// Writes a file for each step, and a file with all steps of the generation.
void write_frames(const WalkedGeneration& walked, const std::filesystem::path& folder) {
    std::string name = fmt::format("generation-{}", walked.number);
    write_single_frames(folder, name, draw_walk(walked));
    write_frame(folder / (name + ".svg"), "Figure 6.4: reproduction and crossover on the hypercube", draw_walk(walked));
    print_out(frames_line((folder / name).string()));
}

void show_generation(const WalkedGeneration& walked, const GenerationOptions& options) {
    print_out((walked.number == 1 ? "" : "\n") + print_walk(walked, options.walk));
    if (!options.frames.empty())
        write_frames(walked, options.frames);
}

ExitCode walk_generations(const GenerationOptions& options) {
    GenerationWalk walk(options.walk);
    if (!options.frames.empty())
        require_folder_for_frames(options.frames);
    for (std::size_t i = 0; i < options.generations; ++i)
        show_generation(walk.next(), options);
    return ExitCode::success;
}

Action declare_generation(Options& command, const std::string&) {
    auto options = std::make_shared<GenerationOptions>();
    add_seed(command, options->walk.seed);
    add_count(command, "--population", options->walk.population, "number of strings, of four bits each").show_default();
    add_count(command, "--generations", options->generations, "number of generations to show")
        .check(not_at_least_one)
        .show_default();
    command.add("--function", options->walk.function, "fitness function of x, the number that the string represents")
        .type("square|ones|impulse")
        .show_default();
    command.add("--crossover", options->walk.crossover_probability, "probability of crossover")
        .type("P")
        .show_default();
    command.add("--mutation", options->walk.mutation_probability, "probability of mutation of a bit")
        .type("P")
        .show_default();
    add_file(command, "--frames", options->frames, "draws the steps on the four-dimensional hypercube, as SVG files",
             "FOLDER");
    return [options] { return walk_generations(*options); };
}

} // namespace

extern const Command generation_command{
    .name = "generation",
    .about = "Shows a generation of a genetic algorithm step by step",
    .place = 130,
    .declare = declare_generation,
};

} // namespace placedpar
