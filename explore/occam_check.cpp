#include "explore/occam_check.hpp"

#include "occam/configuration/configurer.hpp"
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
    const bool has_syntax = !reporter.failed();
    if (has_syntax) {
        leave_out_unwanted(parsed.options, wanted);
        occam::check(*parsed.program, parsed.options, reporter, change);
    }
    OccamCheck result{.program = std::move(parsed.program), .options = parsed.options};
    result.main = occam::main_procedure(*result.program);
    result.parsed = has_syntax;
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

OccamCheck check_configuration_source(std::shared_ptr<const SourceFile> file) {
    Reporter reporter;
    occam::ParseOptions options;
    options.built_in = [](const std::string& name) { return occam::library_text(name); };
    OccamCheck result{.program = occam::parse(std::move(file), options, reporter).program, .options = {}};
    result.parsed = !reporter.failed();
    if (result.parsed)
        result.configured =
            std::make_shared<const occam::Configured>(occam::Configurer(*result.program, {}, reporter).run());
    result.failed = reporter.failed();
    return result;
}

} // namespace placedpar
