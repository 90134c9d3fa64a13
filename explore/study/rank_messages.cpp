#include "explore/study/rank_messages.hpp"

#include "report/manifest.hpp"
#include "runtime/fingerprint.hpp"

#include <boost/json.hpp>

namespace placedpar {

namespace {

boost::json::object json_of(const StudyOutcome& outcome) {
    return {{"ended", outcome.ended},
            {"time_ps", outcome.time.count()},
            {"fingerprint", outcome.fingerprint},
            {"netlist_hash", outcome.netlist_hash},
            {"refused", outcome.refused},
            {"figures", figures_text(outcome.figures)}};
}

StudyOutcome outcome_from(const boost::json::object& json) {
    return {.ended = boost::json::value_to<std::string>(json.at("ended")),
            .time = Time{json.at("time_ps").to_number<std::int64_t>()},
            .fingerprint = json.at("fingerprint").to_number<std::uint64_t>(),
            .netlist_hash = json.at("netlist_hash").to_number<std::uint64_t>(),
            .refused = boost::json::value_to<std::string>(json.at("refused")),
            .figures = figures_from(boost::json::value_to<std::string>(json.at("figures")))};
}

void mix(Fingerprint& fingerprint, const std::string& text) {
    fingerprint.mix(text.size());
    for (char each : text)
        fingerprint.mix(static_cast<unsigned char>(each));
}

} // namespace

std::string text_of(const RankMessage& message) {
    boost::json::object json{{"kind", static_cast<int>(message.kind)}, {"text", message.text}};
    if (message.run) {
        json["set"] = boost::json::value_from(message.run->set);
        json["seed"] = message.run->seed;
    }
    if (message.outcome)
        json["outcome"] = json_of(*message.outcome);
    return boost::json::serialize(json);
}

RankMessage rank_message_from(const std::string& text) {
    const boost::json::object json = read_kept_json(text).as_object();
    RankMessage message{static_cast<RankMessage::Kind>(json.at("kind").to_number<int>()),
                        boost::json::value_to<std::string>(json.at("text"))};
    if (json.contains("set"))
        message.run = {boost::json::value_to<Overrides>(json.at("set")), json.at("seed").to_number<std::uint64_t>()};
    if (json.contains("outcome"))
        message.outcome = outcome_from(json.at("outcome").as_object());
    return message;
}

std::string digest_of(const StudySource& source) {
    Fingerprint fingerprint;
    for (const auto& [path, text] : source.texts)
        mix(fingerprint, text);
    mix(fingerprint, source.options);
    mix(fingerprint, version_text());
    return hex(fingerprint.value());
}

} // namespace placedpar
