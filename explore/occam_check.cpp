#include "explore/occam_check.hpp"

#include "occam/library/library.hpp"
#include "text/reporter.hpp"

#include <utility>

namespace placedpar {

namespace {

void leave_out_unwanted(occam::SourceOptions& options, const occam::SourceOptions& wanted) {
    options.usage_checks &= wanted.usage_checks;
    options.alias_checks &= wanted.alias_checks;
    options.range_checks &= wanted.range_checks;
    options.run_time_checks &= wanted.run_time_checks;
}

} // namespace

OccamCheck check_occam_source(std::shared_ptr<const SourceFile> file, std::vector<std::filesystem::path> folders,
                              const occam::SourceOptions& wanted, Reporter& reporter,
                              std::shared_ptr<const SourceFile> standard_input,
                              const occam::ChangeDeclaration& change) {
    occam::ParseOptions options;
    options.folders = std::move(folders);
    options.built_in = [&standard_input](const std::string& name) {
        return standard_input && name == "standard input" ? standard_input->text() : occam::library_text(name);
    };
    occam::Parsed parsed = occam::parse(std::move(file), options, reporter);
    if (!reporter.failed()) {
        leave_out_unwanted(parsed.options, wanted);
        occam::check(*parsed.program, parsed.options, reporter, change);
    }
    OccamCheck result{.program = std::move(parsed.program), .options = parsed.options};
    result.main = occam::main_procedure(*result.program);
    result.failed = reporter.failed();
    return result;
}

OccamCheck check_occam_source(std::shared_ptr<const SourceFile> file, std::vector<std::filesystem::path> folders,
                              const occam::SourceOptions& wanted, std::shared_ptr<const SourceFile> standard_input,
                              const occam::ChangeDeclaration& change) {
    Reporter reporter;
    OccamCheck result =
        check_occam_source(std::move(file), std::move(folders), wanted, reporter, std::move(standard_input), change);
    result.diagnostics = reporter.take();
    result.not_shown = reporter.not_shown();
    return result;
}

} // namespace placedpar
