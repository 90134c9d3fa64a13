#include "monitor/memory/diagnosis_json.hpp"
#include "tests/identification/on_line/transient.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

std::string text_of(const Diagnosis& diagnosis) { return boost::json::serialize(state_json(diagnosis.state())); }

} // namespace

TEST_CASE("the state goes through JSON and on as if nothing had been") {
    for (std::size_t cut : {0u, 3u, 7u, 12u, 29u}) {
        Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
        diagnosis.change({Configuration::c, LinkSet::all()});
        Transient transient(Configuration::c, LinkSet::all(), {0.0150, 0.0086, 0.0200, 0.0300});
        feed(diagnosis, transient, 0, cut);
        boost::json::value stored = boost::json::parse(text_of(diagnosis));
        Diagnosis restored(state_from(stored, {}), {}, 1);
        CHECK(restored.state() == diagnosis.state());
        CHECK(text_of(restored) == text_of(diagnosis));
        for (std::size_t i = cut; i < 30; ++i) {
            diagnosis.take(transient.sample(0, i));
            restored.take(transient.sample(0, i));
        }
        CHECK(text_of(restored) == text_of(diagnosis));
    }
}
