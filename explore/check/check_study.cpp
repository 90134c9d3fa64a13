#include "explore/check/languages.hpp"

#include "explore/check/check_file.hpp"
#include "explore/occam_program.hpp"
#include "explore/study/study_file.hpp"
#include "text/counted.hpp"
#include "text/refused_text.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace placedpar {

namespace {

/// Returns the first run that satisfies the study's condition. Returns nothing if none of the first 10,000 runs
/// satisfies the condition.
std::optional<StudyRun> first_run(const Study& study) {
    constexpr std::uint64_t most_tried = 10'000;
    const StudyRuns runs(study);
    for (std::uint64_t i = 0; i < std::min(runs.count(), most_tried); ++i)
        if (auto run = runs.at(i))
            return run;
    return std::nullopt;
}

/// Moves a fault that has no line from the netlist to the study, because the netlist may not exist. The message then
/// begins with the netlist's path.
void put_in_study(Diagnostic& fault, const std::filesystem::path& study) {
    if (!fault.location.file || fault.location.line > 0)
        return;
    const std::string message = fault.location.file->path() + ": " + fault.message;
    fault.location = fault_of_whole(study, "").location;
    fault.message = message;
}

CheckedFile check_netlist_of(const Study& study, const std::filesystem::path& path, const Catalogue& catalogue) {
    ReadOptions read = study.read;
    read.make_netlist = netlist_maker({}); // the study reads its netlist in this way, too
    const auto run = first_run(study);
    CheckedFile checked = check_netlist(study.netlist, catalogue, run ? run->set : Overrides{}, read);
    for (Diagnostic& each : checked.diagnostics)
        put_in_study(each, path);
    checked.included.push_back(study.netlist);
    checked.summary = fmt::format("{}: {} of {}\n", path.string(), counted(study.count(), "run"), study.netlist);
    return checked;
}

} // namespace

CheckedFile check_study(const std::filesystem::path& path, const Catalogue& catalogue) {
    CheckedFile checked;
    try {
        checked = check_netlist_of(read_study(path.string()), path, catalogue);
    } catch (const RefusedText& refused) {
        checked.diagnostics = refused.diagnostics();
    } catch (const UserError& refused) {
        checked.diagnostics = {fault_of_whole(path, refused.what())};
    }
    checked.language = "study";
    return checked;
}

} // namespace placedpar
