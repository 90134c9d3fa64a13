#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "runtime/fingerprint.hpp"

#include <fmt/format.h>

#include <optional>

namespace placedpar {

namespace {

/// A published rate of a link. 1 Kbyte/s is 1000 bytes per second. With both directions in use, the rate is the sum of
/// both.
struct LinkRate {
    const char* source;
    const char* name;
    Overrides link;
    double kbytes_per_s;
    double tolerance_percent;
    Origin origin;
    std::optional<double> tolerance_kbytes_per_s = {};
};

const std::vector<LinkRate>& databook_rates() {
    constexpr const char* table = "databook, table 8.1";
    using enum Origin;
    static const std::vector<LinkRate> rates{
        {table, "5 Mbit/s, one way", {{"speed", "5M"}}, 450, 3, outcome},
        {table, "5 Mbit/s, both ways", {{"speed", "5M"}, {"both_ways", "1"}}, 670, 3, fitted},
        {table, "10 Mbit/s, one way", {{"speed", "10M"}}, 910, 3, outcome},
        {table, "10 Mbit/s, both ways", {{"speed", "10M"}, {"both_ways", "1"}}, 1250, 3, fitted},
        {table, "20 Mbit/s, one way", {}, 1740, 3, fitted},
        {table, "20 Mbit/s, both ways", {{"both_ways", "1"}}, 2350, 3, fitted},
        {"databook: \"about .8 Mbyte/s\"", "no overlapped acknowledges", {{"overlapped", "0"}}, 800, 0, outcome, 50},
    };
    return rates;
}

/// Returns rates measured on machines of 20 Mbit/s.
const std::vector<LinkRate>& measured_rates() {
    constexpr const char* koontz = "K. Koontz, comp.sys.transputer, January 1991";
    using enum Origin;
    static const std::vector<LinkRate> rates{
        {koontz, "direct", {}, 1750, 3, fitted},
        {koontz, "through one C004", {{"switches", "1"}}, 1330, 3, outcome},
        {"Poznan, 2008: 923 to 930", "through three C004", {{"switches", "3"}}, 926.5, 1, fitted},
    };
    return rates;
}

class LinkRates {
public:
    explicit LinkRates(const ReplayContext& context) : context_(context) {}

    Comparison compare(const std::string& name, const std::vector<LinkRate>& rates) {
        Comparison comparison{.name = name, .against = "publ.", .judged = true, .names_origins = true};
        for (const LinkRate& rate : rates)
            comparison.add({.row = rate.name,
                            .column = "rate",
                            .unit = "Kbyte/s",
                            .reference = rate.kbytes_per_s,
                            .simulated = simulated(rate),
                            .tolerance_percent = rate.tolerance_percent,
                            .origin = rate.origin,
                            .tolerance = rate.tolerance_kbytes_per_s,
                            .decimals = 0,
                            .source = rate.source});
        return comparison;
    }

    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    double simulated(const LinkRate& rate) {
        context_.progress(rate.name);
        RunReport report = run_to_the_end(context_.examples / "machine/links" / "link.cfs", rate.link, context_);
        fingerprint_.mix(report.result.fingerprint);
        double there = report.measured("receiver[0]", "rate");
        return rate.link.contains("both_ways") ? there + report.measured("receiver[1]", "rate") : there;
    }

    const ReplayContext& context_;
    Fingerprint fingerprint_;
};

Replay replay_links(const ReplayContext& context) {
    LinkRates rates(context);
    Replay replay{.comparisons = {rates.compare("the databook's table 8.1", databook_rates()),
                                  rates.compare("measured on machines", measured_rates())}};
    replay.constants =
        "   published:  a byte is 11 bits and its acknowledge 2; 1.75 bit times through a C004 (its manual)\n"
        "   fitted:     an acknowledge begins 5.2 bit times after its byte, the next byte 3.6 bit times and 120 ns\n"
        "               after the acknowledge. Fitted to these figures, except 10 and 5 Mbit/s one way, one C004 and "
        "the\n               databook's last figure; at 20 Mbit/s, both are within the published 5 to 6 bit times\n";
    replay.fingerprint = rates.fingerprint();
    return replay;
}

} // namespace

extern const Experiment links_experiment{
    .name = "links",
    .about = "data rates of links, compared with the databook and with measured machines",
    .chapter = "machine",
    .number = 1,
    .run = replay_links,
};

} // namespace placedpar
