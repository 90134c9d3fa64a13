#include "monitor/memory/state_store.hpp"

#include "monitor/memory/diagnoses.hpp"
#include "monitor/memory/diagnosis_json.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <map>
#include <utility>

namespace placedpar::monitor {

using namespace identification;

namespace fs = std::filesystem;
namespace json = boost::json;

namespace {

/// The largest number of machines whose states are saved after one message. The number is small, so that no client
/// waits long.
constexpr int states_at_once = 4;

/// Returns the settings that determine the stored states and the result of processing messages again.
std::string settings_text(const Diagnoses& diagnoses) {
    const DiagnosisSettings& s = diagnoses.settings();
    return fmt::format("--seed {} --population {} --bits {} --window {} --trials {} --gate {}", diagnoses.seed(),
                       s.search.population, s.bits, s.search.window.length, s.search.window.trials,
                       s.gate.slope_psi_per_s);
}

/// Returns, for each machine, the last message that need not be processed again. Either the stored state contains this
/// message, or the machine was forgotten later.
std::map<std::string, std::uint64_t> taken_already(const StateContent& content) {
    std::map<std::string, std::uint64_t> taken;
    for (const KeptMessage& message : content.messages)
        if (message.text == forget_text)
            taken[message.machine] = message.number;
    for (const KeptState& state : content.machines)
        taken[state.machine] = std::max(taken[state.machine], state.taken);
    return taken;
}

void replay(Diagnoses& diagnoses, const KeptMessage& message, const fs::path& path) {
    try {
        diagnoses.replay(message.machine, message.text);
    } catch (const std::exception& error) {
        throw UserError(fmt::format("{}: message {} of \"{}\" cannot be processed again: {}", path.string(),
                                    message.number, message.machine, error.what()));
    }
}

std::string plural(std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

} // namespace

StateStore::StateStore(const fs::path& path, Diagnoses& diagnoses, std::uint64_t most_history)
    : path_(path), diagnoses_(diagnoses) {
    StateContent content;
    file_ = std::make_unique<StateFile>(path, settings_text(diagnoses), most_history, content);
    if (!content.said.empty())
        said_ = content.said + "; ";
    if (!content.trouble.empty())
        fall_back(content.trouble);
    last_message_ = trimmed_ = content.last_message;
    for (const KeptState& state : content.machines)
        restore_state(state);
    take_again(content);
    noted_alarms_ = file_->history().noted_alarms();
    if (said_.ends_with("; "))
        said_.resize(said_.size() - 2);
}

StateStore::~StateStore() = default;

void StateStore::restore_state(const KeptState& kept) {
    try {
        diagnoses_.add(state_from(json::parse(kept.state), diagnoses_.settings()));
    } catch (const std::exception& error) {
        throw UserError(fmt::format("{}: this state file cannot be used: the state of \"{}\": {}; use another --state "
                                    "file",
                                    path_.string(), kept.machine, error.what()));
    }
}

void StateStore::take_again(const StateContent& content) {
    auto taken = taken_already(content);
    std::size_t count = 0;
    Transaction transaction;
    for (const KeptMessage& message : content.messages)
        if (message.number > taken[message.machine]) {
            replay(diagnoses_, message, path_);
            backlog_.add(message.machine, message.number, 0, 0);
            ++count;
        }
    for (; !backlog_.empty(); backlog_.drop(std::string(backlog_.oldest_machine())))
        transaction.entries.push_back(state_of(diagnoses_.named(backlog_.oldest_machine())));
    if (!content.messages.empty()) {
        transaction.entries.push_back(TrimmedMessages{last_message_});
        commit_now(transaction);
    }
    if (!diagnoses_.all().empty())
        said_ += fmt::format("{}: {} restored{}", path_.string(), plural(diagnoses_.all().size(), "machine"),
                             count == 0 ? "" : fmt::format(", {} processed again", plural(count, "message")));
}

void StateStore::commit_now(const Transaction& transaction) {
    if (!keeping_)
        return;
    try {
        file_->commit(std::span(&transaction, 1));
    } catch (const store::DatabaseError& error) {
        fall_back(error.what());
    }
}

/// Continues without storing, until write_anew() succeeds.
void StateStore::fall_back(const std::string& why) {
    trouble_ = fmt::format("{}: cannot be written: {}", path_.string(), why);
    keeping_ = complete_ = false;
}

void StateStore::start(std::function<void(WriteProgress)> tell) {
    writer_ = std::make_unique<Writer>(*file_, [this, tell = std::move(tell)](WriteProgress progress) {
        if (!progress.trouble.empty())
            progress.trouble = fmt::format("{}: cannot be written: {}", path_.string(), progress.trouble);
        tell(std::move(progress));
    });
}

void StateStore::note(const WriteProgress& progress) {
    if (progress.transactions < anew_ticket_)
        return; // since that error everything has been stored anew, so the result no longer matters
    complete_ = progress.trouble.empty();
    if (!complete_)
        keeping_ = false;
}

std::uint64_t StateStore::put(Transaction transaction) {
    if (keeping_)
        last_ticket_ = writer_->put(std::move(transaction));
    return last_ticket_;
}

std::uint64_t StateStore::record(const std::string& machine, std::string_view message, std::size_t generations,
                                 std::vector<Entry> history) {
    Transaction transaction{{KeptMessage{++last_message_, machine, std::string(message)}}};
    std::ranges::move(history, std::back_inserter(transaction.entries));
    backlog_.add(machine, last_message_, message.size(), generations);
    return put(std::move(transaction));
}

UnwrittenState StateStore::state_of(const Diagnosis& diagnosis) const {
    return {diagnosis.name(), last_message_, std::make_shared<const Diagnosis::State>(diagnosis.state())};
}

/// Adds the state of a diagnosis, and trims the messages that are no longer needed once this state is stored.
void StateStore::add_state(Transaction& transaction, const Diagnosis& diagnosis) {
    transaction.entries.push_back(state_of(diagnosis));
    backlog_.drop(diagnosis.name());
    std::uint64_t up_to = backlog_.empty() ? last_message_ : backlog_.oldest_number() - 1;
    if (up_to > trimmed_)
        transaction.entries.push_back(TrimmedMessages{trimmed_ = up_to});
}

std::uint64_t StateStore::save(const Diagnosis& diagnosis) {
    Transaction transaction;
    add_state(transaction, diagnosis);
    return put(std::move(transaction));
}

std::uint64_t StateStore::forget(const std::string& machine) {
    backlog_.drop(machine);
    return put({{KeptMessage{++last_message_, machine, forget_text}, ForgottenMachine{machine}}});
}

std::uint64_t StateStore::change_history(Entry entry) { return put({{std::move(entry)}}); }

void StateStore::relieve() {
    for (int i = 0; i < states_at_once && !backlog_.empty(); ++i) {
        if (backlog_.bytes() <= most_backlog_bytes && backlog_.generations() <= most_backlog_generations)
            return;
        Transaction transaction;
        add_state(transaction, diagnoses_.named(std::string(backlog_.oldest_machine())));
        put(std::move(transaction));
    }
}

void StateStore::write_anew(std::vector<KeptAlarm> open_alarms, double at) {
    keeping_ = true;
    Transaction transaction{{OpenAlarms{std::move(open_alarms), at}}, last_message_};
    for (const auto& [name, diagnosis] : diagnoses_.all())
        transaction.entries.push_back(state_of(diagnosis));
    backlog_.clear();
    trimmed_ = last_message_;
    anew_ticket_ = put(std::move(transaction));
}

void StateStore::finish() {
    std::string trouble = writer_->wait();
    writer_.reset();
    file_.reset();
    if (!trouble.empty())
        throw UserError(fmt::format("{}: the latest state cannot be written: {}", path_.string(), trouble));
}

} // namespace placedpar::monitor
