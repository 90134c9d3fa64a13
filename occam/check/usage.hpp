#pragma once

#include "occam/check/region.hpp"
#include "text/reporter.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace placedpar::occam {

/// Checks two rules of occam, which keep processes from interfering with each other and make each variable have one
/// name at a time. REQUIRES: the program's names and types were checked without errors.
///
/// Parallel usage: a component of a PAR must not use variables that another component changes. Only one component may
/// output to a channel, and only one component may input from it. Elements of an array count as different variables if
/// their subscripts depend only on constants and on replicators with constant base and count. For this, each value of
/// the replicators is tried, up to a limit.
///
/// Aliases: within the scope of an abbreviation, only the abbreviation's name may be used for the variable. Variables
/// in the expression of a VAL abbreviation must not be changed. A parameter by reference must not overlap with another
/// parameter, or with a variable that the PROC itself uses.
///
/// The program is visited once. Each use of a variable or channel, an access, is appended to a log, in which the
/// accesses of a component of a PAR follow one another. A call appends the called routine's accesses to variables that
/// are declared outside of it.
class UsageCheck {
public:
    UsageCheck(const Program& program, bool usage, bool aliases, Reporter& reporter)
        : program_(program), usage_(usage), aliases_(aliases), reporter_(reporter) {}
    void check_program();

private:
    using DeclarationList = std::vector<DeclarationBox>;
    /// Holds a range of positions in the log: from `first` up to, but without, `end`.
    struct Stretch {
        std::size_t first = 0, end = 0;
    };
    /// Describes an abbreviation whose scope contains the place that is being visited.
    struct Active {
        const Declaration* declaration = nullptr;
        Access access;
        bool is_changeable = false; ///< true: the abbreviation is another name of the accessed variable; false: it is a
                                    ///< VAL whose value depends on the variable
    };
    /// Holds the accesses in an argument of a call, or in a target of an assignment.
    struct Part {
        std::optional<Access> changed;
        std::vector<Access> read;
    };
    struct Interval {
        Region region;
        std::int64_t component = 0;
        const Access* access = nullptr;
    };

    // The visit (usage.cpp)
    void visit(const Process&);
    void visit(const Process*);
    void visit_form(const Process&, const Skip&) {}
    void visit_form(const Process&, const Stop&) {}
    void visit_form(const Process&, const Assignment&);
    void visit_form(const Process&, const Input&);
    void visit_form(const Process&, const Delay&);
    void visit_form(const Process&, const VariantInput&);
    void visit_form(const Process&, const Output&);
    void visit_form(const Process&, const Sequence&);
    void visit_form(const Process&, const Parallel&);
    void visit_form(const Process&, const If&);
    void visit_form(const Process&, const Case&);
    void visit_form(const Process&, const While&);
    void visit_form(const Process&, const Alternation&);
    void visit_form(const Process&, const Instance&);
    void visit_form(const Process&, const Scope&);
    void visit_form(const Process&, const Processor&);
    void visit_form(const Process&, const Wiring&) {}
    void visit_if(const If&);
    void visit_alternation(const Alternation&);
    void visit_input(const Input&);
    void visit_variants(const VariantInput&);
    void input_items(const std::vector<Item>&);
    void open_replicator(const std::optional<Replicator>&);
    void close_replicator(const std::optional<Replicator>&);
    void declare(const DeclarationList&);
    void declare(const Declaration&);
    void abbreviate(const Declaration&, const Expression& value, bool is_value);
    void visit_routine(const Declaration&, const DeclarationList& parameters, const ValueProcess* function,
                       const Process* body);
    void visit_values(const ValueProcess&);
    std::vector<Access> outside_accesses(std::size_t first, std::uint64_t since) const;

    // Accesses (usage_access.cpp)
    void read(const Expression&);
    void read_path(const Expression&);
    void read_indices(const Expression&);
    void use(const Expression&, AccessKind);
    std::optional<Access> access_of(const Expression&, AccessKind) const;
    void log(Access);
    Part changed_part(const Expression&);
    Part read_part(const Expression&);
    void call(const Declaration&, const std::vector<Expression>& arguments, const Place&);
    Part argument(const Expression&, const Declaration& routine, std::size_t index);
    std::vector<Access> accesses_since(std::size_t first) const;

    // Parallel usage (parallel_usage.cpp)
    void check_parallel(const Parallel&, const std::vector<Stretch>& components, std::uint64_t since);
    bool check_base(const Parallel&, const std::vector<std::pair<std::int64_t, const Access*>>&);
    bool check_intervals(std::vector<Interval>&);
    void report_parallel(const Access&, const Access&);
    void intervals_of(const Parallel&, std::int64_t component, const Access&, IndexValues&, std::vector<Interval>&);
    void check_parts(const std::vector<Part>&, bool only_certain, const std::string& what);

    // Aliases (aliases.cpp)
    void check_active(const Access&);
    bool is_named_by(const Access&, const Declaration&) const;
    void check_free(const Declaration& routine, const std::vector<Part>&, const Place&);
    void check_block(const Expression& target, const Expression& value);

    const Program& program_;
    bool usage_ = false, aliases_ = false;
    Reporter& reporter_;
    Replicators replicators_;
    std::unordered_set<const Declaration*> open_indices_; ///< indices of the replicators that contain the present place
    std::vector<Access> log_;
    std::vector<Active> active_;
    std::uint64_t clock_ = 0; ///< number of declarations visited so far
    std::unordered_map<const Declaration*, std::uint64_t> declared_;
    std::unordered_map<const Declaration*, std::vector<Access>>
        summaries_; ///< accesses of each routine to variables outside of it
};

} // namespace placedpar::occam
