#include "gaprocs/search_progress.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar {

SearchProgress::SearchProgress(Search& search, std::string name, Checkpoints* checkpoints)
    : name_(std::move(name)), checkpoints_(checkpoints) {
    const SearchCheckpoint* begin = checkpoints ? checkpoints->begin_of(name_) : nullptr;
    if (!begin)
        return;
    to_pass_over_ = begin->search.generation;
    search.go_on_from(begin->search);
    if (!search.is_valid(begin->best))
        throw UserError("the best individual of the checkpoint does not belong to this search");
    populations_ = Fingerprint(begin->populations);
    best_ = begin->best;
    improvements_ = begin->improvements;
}

void SearchProgress::require_passed(const Search& search) const {
    if (to_pass_over_ > 0)
        throw UserError(fmt::format("this search ends with generation {}, before the generation of the checkpoint: let "
                                    "the search run longer, or delete the checkpoint to start from the beginning",
                                    search.generation() - to_pass_over_));
}

void SearchProgress::note_population(const Search& search) {
    for (const Genome& genome : search.population())
        for (std::uint64_t word : genome.words())
            populations_.mix(word);
}

bool SearchProgress::note_best(const Search& search) {
    if (best_ && search.best().fitness <= best_->fitness)
        return false;
    best_ = search.best();
    improvements_.push_back({search.generation(), best_->fitness});
    return true;
}

void SearchProgress::keep(const Search& search) const {
    if (checkpoints_ && checkpoints_->is_due(search.generation()))
        checkpoints_->keep(name_, {search.state(), populations_.value(), *best_, improvements_});
}

} // namespace placedpar
