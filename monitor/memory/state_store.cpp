#include "monitor/memory/state_store.hpp"

#include "monitor/memory/diagnosis_json.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace placedpar::monitor {

using namespace identification;

namespace fs = std::filesystem;
namespace json = boost::json;

namespace {

constexpr int file_version = 1;

/// A whole state file, but one of another version or other settings.
class OtherState : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

fs::path beside(const fs::path& path, const char* ending) {
    fs::path other = path;
    other += ending;
    return other;
}

/// Throws, before a journal is made beside it, when the path is something other than a file.
fs::path path_of_file(fs::path path) {
    if (is_standard_stream(path))
        throw UserError("-: standard output is no state file; name a file, it need not exist yet");
    if (fs::exists(path) && !fs::is_regular_file(path))
        throw UserError(fmt::format("{}: it is {}, no state file; name a file, it need not exist yet", path.string(),
                                    fs::is_directory(path) ? "a folder" : "a device"));
    return path;
}

/// Its errors name the state file, too: the journal is nothing that a user asked for.
Journal journal_of(const fs::path& path) {
    try {
        return Journal(beside(path, ".journal"));
    } catch (const UserError& error) {
        throw UserError(fmt::format("--state {}: {}", path.string(), error.what()));
    }
}

std::string text_of_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw std::runtime_error(std::strerror(errno));
    return std::string(std::istreambuf_iterator<char>(in), {});
}

json::value parsed(const std::string& text) {
    if (text.empty())
        throw std::runtime_error("it is empty");
    json::error_code error;
    json::value value = json::parse(text, error);
    if (error == json::error::incomplete)
        throw std::runtime_error(fmt::format("it breaks off after {} bytes", text.size()));
    if (error || !value.is_object() || !value.get_object().contains("placedpar_monitor_state"))
        throw std::runtime_error("it is no state file of the monitor");
    return value;
}

/// Brings a file, or a folder's names, to the disk itself.
void sync_path(const fs::path& path) {
    int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || ::fsync(file) != 0) {
        int reason = errno;
        if (file >= 0)
            ::close(file);
        throw UserError(fmt::format("{}: cannot be brought to the disk: {}", path.string(), std::strerror(reason)));
    }
    ::close(file);
}

/// The settings that the populations of the state file, or the messages of the journal taken again, depend on.
std::string settings_text(const Diagnoses& diagnoses) {
    const DiagnosisSettings& s = diagnoses.settings();
    return fmt::format("--seed {} --population {} --bits {} --window {} --trials {} --gate {}", diagnoses.seed(),
                       s.search.population, s.bits, s.search.window.length, s.search.window.trials, s.gate_psi_per_s);
}

/// Takes a record of the journal: the machine's name, a blank, the message.
void take_again(Diagnoses& diagnoses, const std::string& record, const std::string& where) {
    std::size_t blank = std::min(record.find(' '), record.size() - 1);
    try {
        diagnoses.replay(record.substr(0, blank), std::string_view(record).substr(blank + 1));
    } catch (const std::exception& error) {
        throw UserError(fmt::format("{} cannot be taken again: {}", where, error.what()));
    }
}

} // namespace

StateStore::StateStore(fs::path path) : path_(path_of_file(std::move(path))), journal_(journal_of(path_)) {}

std::string StateStore::restore(Diagnoses& diagnoses) {
    read_state_file(diagnoses);
    std::string said;
    read_journal(diagnoses, said);
    if (!diagnoses.all().empty())
        said = fmt::format("{}: {} machine{} restored{}", path_.string(), diagnoses.all().size(),
                           diagnoses.all().size() == 1 ? "" : "s", said);
    write(diagnoses);
    return said;
}

void StateStore::take_state(const json::value& state, Diagnoses& diagnoses) {
    if (state.at("placedpar_monitor_state").to_number<int>() != file_version)
        throw OtherState(fmt::format("it is of another version than {}; use another --state file", file_version));
    if (std::string was(state.at("settings").as_string()); was != settings_text(diagnoses))
        throw OtherState(
            fmt::format("it was written with {}, this is {}; use the same options, or another --state file", was,
                        settings_text(diagnoses)));
    epoch_ = state.at("epoch").to_number<std::uint64_t>();
    for (const json::value& diagnosis : state.at("machines").as_array())
        diagnoses.add(state_from(diagnosis, diagnoses.settings()));
}

void StateStore::read_state_file(Diagnoses& diagnoses) {
    if (!fs::exists(path_))
        return;
    auto refuse = [&](const std::string& why) {
        throw UserError(fmt::format("{}: this state file cannot be used: {}", path_.string(), why));
    };
    auto damaged = [&](const std::string& why) {
        refuse(fmt::format("{}; put a whole one there, or move it and {}.journal away and begin with nothing known",
                           why, path_.string()));
    };
    try {
        take_state(parsed(text_of_file(path_)), diagnoses);
    } catch (const OtherState& other) {
        refuse(other.what());
    } catch (const boost::system::system_error& error) {
        damaged(fmt::format("a part of it is wrong: {}", error.code().message()));
    } catch (const std::out_of_range&) {
        damaged("a part of it is missing");
    } catch (const std::exception& error) {
        damaged(error.what());
    }
}

void StateStore::read_journal(Diagnoses& diagnoses, std::string& said) {
    fs::path path = beside(path_, ".journal");
    JournalContent content = journal_.read();
    if (content.epoch > epoch_)
        throw UserError(fmt::format("{}: it goes on from a later state file (epoch {}) than {} (epoch {}); put "
                                    "that file back, or move the journal away",
                                    path.string(), content.epoch, path_.string(), epoch_));
    if (content.epoch == epoch_ && !content.records.empty()) {
        for (std::size_t i = 0; i < content.records.size(); ++i)
            take_again(diagnoses, content.records[i], fmt::format("{}: record {}", path.string(), i + 1));
        said += fmt::format(", {} messages taken again", content.records.size());
    }
    if (content.damaged_bytes > 0) {
        fs::copy_file(path, beside(path_, ".damaged"), fs::copy_options::overwrite_existing);
        said += fmt::format(", {} bytes at the journal's end are torn: left out, kept in {}", content.damaged_bytes,
                            beside(path_, ".damaged").string());
    }
}

void StateStore::record(const std::string& machine, std::string_view message, std::size_t generations) {
    if (!complete_)
        return;
    complete_ = false;
    journal_.append(fmt::format("{} {}", machine, message));
    complete_ = true;
    generations_ += generations;
}

void StateStore::write(const Diagnoses& diagnoses) {
    json::array all;
    for (const auto& [name, diagnosis] : diagnoses.all())
        all.push_back(state_json(diagnosis.state()));
    json::object state{{"placedpar_monitor_state", file_version},
                       {"settings", settings_text(diagnoses)},
                       {"epoch", epoch_ + 1},
                       {"machines", std::move(all)}};
    // On the disk before it takes the old one's name: with a loss of power, one of the two is there, whole.
    fs::path next = beside(path_, ".next");
    write_whole(next, json::serialize(state) + "\n");
    sync_path(next);
    complete_ = false; // until the journal, too, is of the new epoch
    fs::rename(next, path_);
    ++epoch_;
    sync_path(fs::absolute(path_).parent_path());
    journal_.begin(epoch_);
    complete_ = true;
    generations_ = 0;
}

} // namespace placedpar::monitor
