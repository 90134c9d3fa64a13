#include "identification/verdict/verdict.hpp"

#include "identification/verdict/way_matrices.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::identification;
using placedpar::hydraulics::AreasFrom;

namespace {

/// Returns a deviation whose leak was present before the movement.
Deviation off_by(double compliance, double leak, double offset, double error = 0.2) {
    return {{compliance, leak, offset, leak}, two_ways_of(WayMatrix::Identity() * error * error)};
}

Verdict after(std::initializer_list<Deviation> movements, AreasFrom valve = AreasFrom::spool) {
    LinkJudge judge;
    for (const Deviation& each : movements)
        judge.take(each, valve);
    return judge.verdict();
}

const Deviation in_health = off_by(0, 0, 0);

} // namespace

TEST_CASE("the verdict names the likeliest fault and its probability") {
    CHECK(verdict_of(off_by(1, 0, 0), true, AreasFrom::spool).kind == VerdictKind::compliance);
    CHECK(verdict_of(off_by(-1, 0, 0), true, AreasFrom::spool).kind == VerdictKind::compliance);
    CHECK(verdict_of(off_by(0, 1, 0), true, AreasFrom::spool).kind == VerdictKind::leak);
    CHECK(verdict_of(off_by(0, 0, -1), true, AreasFrom::spool).kind == VerdictKind::offset);
    CHECK(verdict_of(off_by(0, 0, -1), true, AreasFrom::servo).kind == VerdictKind::drift);
    for (VerdictKind leak : {VerdictKind::leak, VerdictKind::leak_or_offset}) // a leak only takes oil away
        CHECK(verdict_of(off_by(0.01, -1, 0.02), true, AreasFrom::spool).kind != leak);
    CHECK(verdict_of(off_by(0, 1, 0, 0.1), true, AreasFrom::spool).probability > 0.999);
    CHECK(verdict_of(off_by(0, 1, 0, 1), true, AreasFrom::spool).probability < 0.7);
    // Both explanations fit equally well.
    Deviation either = off_by(1, 1, 0, 0.1);
    either.by[index_of(FaultHypothesis::leak_before)] = 0;
    CHECK(verdict_of(either, true, AreasFrom::spool).probability == test::nearly(0.5, 0.01));
}

TEST_CASE("a sound link has the right probability") {
    auto sound = [](const Deviation& mean, AreasFrom valve = AreasFrom::spool) {
        Verdict verdict = verdict_of(mean, false, valve);
        CHECK(verdict.kind == VerdictKind::sound);
        return verdict.probability;
    };
    CHECK(sound(off_by(0, 0, 0, 0.1)) > 0.99);
    CHECK(sound(off_by(0.3, 0, 0, 0.3)) > 0.7);
    CHECK(sound(off_by(0.6, 0, 0, 0.3)) < 0.5);
    // With no information, sound is as likely as each of the six faults.
    CHECK(sound(off_by(0, 0, 0, 100)) == test::nearly(1.0 / 7, 0.01));
    // Measured areas have no offset, however uncertain the estimate.
    Deviation areas = off_by(0, 0, 0, 0.1);
    Eigen::Map<WayMatrix>(areas.covariance.data())(2, 2) = 100;
    CHECK(sound(areas, AreasFrom::areas) > 0.99);
    CHECK(sound(areas) < 0.5);
    CHECK(how_sure(0.874) == "87 % sure");
    CHECK(how_sure(1) == "more than 99 % sure");
}

TEST_CASE("a leak is recognised despite the correlation of leak and offset") {
    Deviation leak = off_by(0, 1, 0);
    Eigen::Map<WayMatrix> covariance(leak.covariance.data());
    covariance(1, 2) = covariance(2, 1) = -0.039; // nearly perfectly correlated
    leak.by = {0, 1, 0.02, 1};
    CHECK(verdict_of(leak, true, AreasFrom::spool).kind == VerdictKind::leak);
}

TEST_CASE("a new leak and an offset are one verdict unless they can be distinguished") {
    // One unit of leak and half a unit of offset cause the same missing flow; the rest before shows no leak.
    const WayVector unknown(0, 1, -0.5, 0);
    const Deviation flow{{0, 0.5, 0.25, 0},
                         two_ways_of(WayMatrix::Identity() * 0.01 + 4 * unknown * unknown.transpose())};
    CHECK(verdict_of(flow, true, AreasFrom::spool).kind == VerdictKind::leak_or_offset);
    CHECK(verdict_of(flow, true, AreasFrom::servo).kind == VerdictKind::leak_or_offset);
    CHECK(size_alone(FaultHypothesis::leak, flow).by == doctest::Approx(1).epsilon(0.1));
    CHECK(size_alone(FaultHypothesis::offset, flow).by == test::nearly(0.5, 0.1));
    CHECK(size_alone(FaultHypothesis::leak, flow).standard_error < 0.3);
    Deviation leak_before = flow;
    leak_before.by[index_of(FaultHypothesis::leak_before)] = 1;
    CHECK(verdict_of(leak_before, true, AreasFrom::spool).kind == VerdictKind::leak);
    // The rest after the movement shows a leak, or none.
    const Deviation leak_after{{0, 1, 0, 0}, two_ways_of(WayMatrix::Identity() * 0.01)},
        none_after{{0, 0, 0.5, 0}, two_ways_of(WayMatrix::Identity() * 0.01)};
    CHECK(verdict_of(leak_after, true, AreasFrom::spool).kind == VerdictKind::leak);
    CHECK(verdict_of(none_after, true, AreasFrom::spool).kind == VerdictKind::offset);
}

TEST_CASE("three movements set the baseline with which a link is compared") {
    CHECK(after({}).kind == VerdictKind::not_enough_evidence);
    CHECK(after({in_health, in_health, in_health}).kind == VerdictKind::not_enough_evidence);
    CHECK(after({in_health, in_health, in_health, in_health}).kind == VerdictKind::sound);
    const Deviation other = off_by(0.8, 0, 0); // within the spread of the machines of a kind
    CHECK(after({other, other, other, other, other}).kind == VerdictKind::sound);
    const Deviation more = off_by(1.8, 0, 0);
    CHECK(after({other, other, other, more, more, more}).kind == VerdictKind::compliance);
}

TEST_CASE("before its baseline a link is compared with its kind") {
    const Deviation leak = off_by(0, 2, 0);
    CHECK(after({leak}).kind == VerdictKind::not_enough_evidence);
    CHECK(after({leak, leak}).kind == VerdictKind::leak);
    CHECK(after({leak, leak, leak, leak, leak, leak}).kind == VerdictKind::leak);
}

TEST_CASE("a movement without excitation does not count as evidence") {
    const Deviation blind = off_by(-4, 3, 2, 4);
    CHECK(after({blind, blind, blind, blind, blind, blind}).kind == VerdictKind::not_enough_evidence);
    const Verdict verdict = after({in_health, blind, in_health, in_health, blind, blind, in_health, blind});
    CHECK(verdict.kind == VerdictKind::sound);
    CHECK(verdict.movements == 1);
}

TEST_CASE("a fault must exceed its standard error, and a sound link must be more likely sound than not") {
    LinkJudge::State state;
    state.first = {in_health, in_health, in_health};
    const double information = 1 / (1.2 * 1.2);
    state.from_itself = {.raised = true,
                         .pull = {information, 0, 0, 0},
                         .information = two_ways_of(WayMatrix::Identity() * information),
                         .movements = 1};
    CHECK(LinkJudge(state).verdict().kind == VerdictKind::cannot_tell);
    state.from_itself.pull[0] = 1.4 * information;
    CHECK(LinkJudge(state).verdict().kind == VerdictKind::compliance);
    const Deviation vague = off_by(0.5, 0, 0, 0.9);
    const Verdict verdict = after({vague, vague, vague, vague});
    CHECK(verdict.kind == VerdictKind::cannot_tell);
    CHECK(verdict.probability < LinkJudge::least_sure_sound);
    CHECK(name_of(verdict.kind) == "cannot tell");
}

TEST_CASE("impossible readings are a sensor fault until a normal movement") {
    LinkJudge judge;
    judge.note_impossible();
    CHECK(judge.verdict().kind == VerdictKind::sensor);
    judge.take(off_by(9, 9, 9), AreasFrom::spool);
    CHECK(judge.verdict().kind == VerdictKind::sensor);
    CHECK(judge.state().first.empty()); // the impossible movement is not kept as evidence
    judge.take(in_health, AreasFrom::spool);
    CHECK(judge.verdict().kind == VerdictKind::not_enough_evidence);
}

TEST_CASE("another source of the valve's position restarts the judgement") {
    LinkJudge judge;
    for (int i = 0; i < 4; ++i)
        judge.take(in_health, AreasFrom::spool);
    judge.take(off_by(0, 0, 1), AreasFrom::servo);
    CHECK(judge.state().first.size() == 1);
}

TEST_CASE("after two movements that nothing explains, a link no longer counts as sound") {
    const Deviation scattered = off_by(0, 0, 0, 4);
    constexpr double great = 300;
    LinkJudge judge;
    for (int i = 0; i < 6; ++i)
        judge.take(in_health, AreasFrom::spool, 1.8);
    CHECK(judge.verdict().kind == VerdictKind::sound);
    judge.take(scattered, AreasFrom::spool, great);
    CHECK(judge.verdict().kind == VerdictKind::sound);
    judge.take(scattered, AreasFrom::spool, great);
    CHECK(judge.verdict().kind == VerdictKind::sensor);
    CHECK(judge.verdict().unexplained == 2);
    judge.take(in_health, AreasFrom::spool, 1);
    CHECK(judge.verdict().kind == VerdictKind::sound);
}

TEST_CASE("movements that say little, or whose readings are explained, do not count as unexplained") {
    LinkJudge judge;
    for (int i = 0; i < 6; ++i)
        judge.take(in_health, AreasFrom::spool);
    for (int i = 0; i < 6; ++i) {
        judge.take(off_by(0, 0, 0, 4), AreasFrom::spool, LinkJudge::greatest_misfit); // hardly more than noise
        judge.take(off_by(0, 0, 0, 400), AreasFrom::spool, 300);                      // steady: says nothing anyway
    }
    CHECK(judge.verdict().kind == VerdictKind::sound);
    CHECK(judge.state().unexplained == 0);
}
