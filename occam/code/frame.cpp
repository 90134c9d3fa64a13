#include "occam/code/frame.hpp"

#include <algorithm>
#include <numeric>

namespace placedpar::occam {

Cell Frame::allocate(int words) {
    const Cell cell{this, Cell::Area::local, top};
    top += words;
    if (uses.size() < static_cast<std::size_t>(top)) {
        uses.resize(static_cast<std::size_t>(top));
        joined.resize(static_cast<std::size_t>(top));
    }
    for (int i = 1; i < words; ++i)
        joined[static_cast<std::size_t>(cell.index + i)] = true;
    return cell;
}

void Frame::use(const Cell& cell, double weight) {
    if (cell.area == Cell::Area::local)
        uses[static_cast<std::size_t>(cell.index)] += weight;
}

namespace {

/// Orders the local words of a frame by use. Words that are joined stay together.
void order_by_use(Frame& frame) {
    struct Block {
        int first, words;
        double use;
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < frame.uses.size(); ++i) {
        if (!frame.joined[i])
            blocks.push_back({static_cast<int>(i), 0, 0});
        ++blocks.back().words;
        blocks.back().use += frame.uses[i];
    }
    std::ranges::stable_sort(blocks, [](const Block& a, const Block& b) { return a.use / a.words > b.use / b.words; });
    frame.position.resize(frame.uses.size());
    int next = 0;
    for (const Block& block : blocks)
        for (int i = 0; i < block.words; ++i)
            frame.position[static_cast<std::size_t>(block.first + i)] = next++;
}

/// Computes what a frame and all frames below it need, from the innermost on.
void size_up(Frame& frame) {
    order_by_use(frame);
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
    case Cell::Area::local:
        return cell.frame->coordinate + cell.frame->low + cell.frame->position[static_cast<std::size_t>(cell.index)];
    case Cell::Area::low: return cell.frame->coordinate + cell.index;
    case Cell::Area::parameter: return parameters + level.uses_link + cell.index;
    case Cell::Area::link: return parameters;
    case Cell::Area::vector: return parameters + level.uses_link + level.parameters;
    case Cell::Area::base: break;
    }
    return cell.frame->coordinate;
}

} // namespace placedpar::occam
