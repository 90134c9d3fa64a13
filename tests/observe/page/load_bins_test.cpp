#include "observe/page/load_bins.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using page::LoadBins;

namespace {

constexpr auto running = LoadBins::State::running, ready = LoadBins::State::ready;

std::string levels_of(const LoadBins& bins, std::size_t track = 0) { return bins.levels(track, running); }

} // namespace

TEST_CASE("a bin has the share of its time in which a track was running") {
    LoadBins bins(8, Time{});
    bins.add(0, running, Time{500}, Time{2500});
    CHECK(bins.width() == Time{1000});
    CHECK(levels_of(bins) == "g/g"); // 32, 63 and 32 of 63
    CHECK(bins.levels(0, ready).empty());
    CHECK(levels_of(bins, 7).empty());
}

TEST_CASE("a bin with any activity is not shown as empty") {
    LoadBins bins(8, Time{});
    bins.add(0, running, Time{0}, Time{1});
    CHECK(levels_of(bins) == "B");
}

TEST_CASE("bins become wider as the run grows and lose nothing") {
    LoadBins bins(4, Time{});
    bins.add(0, running, Time{0}, Time{1000});
    bins.add(1, ready, Time{3000}, Time{4000});
    bins.add(0, running, Time{7000}, Time{8000});
    CHECK(bins.width() == Time{2000});
    CHECK(levels_of(bins) == "gAAg");
    CHECK(bins.levels(1, ready) == "Ag");
    bins.merge_to(1);
    CHECK(levels_of(bins) == "Q"); // a quarter of 63
}

TEST_CASE("the first bin begins at the beginning of the page") {
    LoadBins bins(4, Time{1'000'000});
    bins.add(0, running, Time{1'001'000}, Time{1'002'000});
    CHECK(levels_of(bins) == "A/");
}
