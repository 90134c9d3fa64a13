#include "occam/code/frame.hpp"

#include <algorithm>

namespace placedpar::occam {

Cell Frame::allocate(int words) {
    const Cell cell{this, Cell::Area::local, top};
    top += words;
    if (uses.size() < static_cast<std::size_t>(top)) {
        uses.resize(static_cast<std::size_t>(top));
        joined.resize(static_cast<std::size_t>(top));
        above_low.resize(static_cast<std::size_t>(top));
    }
    for (int i = 1; i < words; ++i)
        joined[static_cast<std::size_t>(cell.index + i)] = true;
    return cell;
}

void Frame::use(const Cell& cell, double weight) {
    if (cell.area == Cell::Area::local)
        uses[static_cast<std::size_t>(cell.index)] += weight;
}

void Frame::need_low(int words) {
    low = std::max(low, words);
    for (int i = 0; i < top; ++i)
        above_low[static_cast<std::size_t>(i)] = std::max(above_low[static_cast<std::size_t>(i)], words);
}

/// Gives each local word its place. Words that are used most get the lowest places. Joined words stay together.
void Frame::order_by_use() {
    struct Block {
        int first, words, least;
        double use;
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (!joined[i])
            blocks.push_back({static_cast<int>(i), 0, 0, 0});
        Block& block = blocks.back();
        ++block.words;
        block.least = std::max(block.least, above_low[i]);
        block.use += uses[i];
    }
    std::ranges::stable_sort(blocks, [](const Block& a, const Block& b) { return a.use / a.words > b.use / b.words; });
    position.resize(uses.size());
    std::vector<bool> taken(uses.size() + static_cast<std::size_t>(low));
    size = low;
    int first_free = 0;
    for (const Block& block : blocks) {
        if (block.use == 0)
            break; // no code uses the words of this block or of the following blocks
        const auto is_free = [&](int place) {
            for (int i = 0; i < block.words; ++i)
                if (taken[static_cast<std::size_t>(place + i)])
                    return false;
            return true;
        };
        int place = std::max(block.least, first_free);
        while (!is_free(place))
            ++place;
        for (int i = 0; i < block.words; ++i) {
            position[static_cast<std::size_t>(block.first + i)] = place + i;
            taken[static_cast<std::size_t>(place + i)] = true;
        }
        while (static_cast<std::size_t>(first_free) < taken.size() && taken[static_cast<std::size_t>(first_free)])
            ++first_free;
        size = std::max<std::int64_t>(size, place + block.words);
    }
}

namespace {

/// Computes the sizes of a frame and of all frames below it, the innermost first.
void size_up(Frame& frame) {
    frame.order_by_use();
    for (const std::vector<Frame*>& components : frame.parallels) {
        std::int64_t words = 0;
        for (Frame* component : components) {
            size_up(*component);
            words += component->words() + component->below;
        }
        frame.need_below(words);
    }
}

void place(Frame& frame, std::int64_t coordinate) {
    frame.coordinate = coordinate;
    for (const std::vector<Frame*>& components : frame.parallels) {
        std::int64_t next = coordinate;
        for (Frame* component : components) {
            next -= component->words();
            place(*component, next);
            next -= component->below;
        }
    }
}

} // namespace

void Level::lay_out() {
    size_up(main);
    place(main, 0);
}

std::int64_t coordinate_of(const Cell& cell) {
    const Level& level = *cell.frame->level;
    const std::int64_t parameters = level.main.words() + 1;
    switch (cell.area) {
    case Cell::Area::local: return cell.frame->coordinate + cell.frame->position[static_cast<std::size_t>(cell.index)];
    case Cell::Area::low: return cell.frame->coordinate + cell.index;
    case Cell::Area::parameter: return parameters + level.uses_link + cell.index;
    case Cell::Area::link: return parameters + cell.index;
    case Cell::Area::vector: return parameters + level.uses_link + level.parameters;
    case Cell::Area::base: break;
    }
    return cell.frame->coordinate;
}

} // namespace placedpar::occam
