#include "iserver/server.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace placedpar::iserver {

/// The requests, as INMOS names them.
enum class RequestTag : std::uint8_t {
    open = 10,
    close,
    read,
    write,
    gets,
    puts,
    flush,
    seek,
    tell,
    eof,
    ferror,
    remove,
    rename,
    getblock,
    putblock,
    isatty,
    getkey = 30,
    pollkey,
    getenv,
    time,
    system,
    exit,
    commandline = 40,
    core,
    version
};

namespace {

void require_fit(std::string_view what, const std::string& text) {
    if (text.size() > longest_reply_text)
        throw UserError(fmt::format("{} has {} bytes; a reply of the host's server can hold at most {}", what,
                                    text.size(), longest_reply_text));
}

std::size_t limited(std::size_t bytes) { return std::min(bytes, longest_reply_text); }

Reply failure() { return Reply(Result::failed); }
Reply success() { return Reply(Result::success); }

/// Replies to a request for the last error of a stream. If the stream had no error, the reply is a failure.
Reply error_of(const Stream& stream) {
    if (stream.error() == 0)
        return failure();
    return success().word(stream.error()).text(std::generic_category().message(stream.error()));
}

Reply get_block(Stream& stream, std::size_t most) {
    const std::string bytes = stream.read(most);
    return bytes.empty() ? failure() : success().text(bytes);
}

Reply put_block(Stream& stream, std::string_view bytes) {
    const std::size_t written = stream.write(bytes);
    return Reply::success_if(written > 0).count(written);
}

Reply get_line(Stream& stream, std::size_t most) {
    const std::optional<std::string> line = stream.line(most);
    return line ? success().text(*line) : failure();
}

Reply put_line(Stream& stream, std::string_view line) {
    const std::string whole = std::string(line) + '\n';
    return Reply::success_if(stream.write(whole) == whole.size());
}

Reply position_of(Stream& stream) {
    const std::optional<std::int32_t> position = stream.tell();
    return position ? success().word(*position) : failure();
}

} // namespace

Server::Server(ServerOptions options, Terminal& terminal)
    : options_(std::move(options)), terminal_(terminal),
      folder_(options_.host_folder.empty() ? HostFolder() : HostFolder(options_.host_folder)),
      quota_(options_.write_limit_bytes), streams_(folder_, terminal_, visible_, quota_) {
    require_fit("the program's command line", options_.command_line);
    require_fit("the whole command line", options_.whole_command_line);
    for (const auto& [name, value] : options_.environment)
        require_fit(fmt::format("the value of \"{}\" in the environment", name), value);
}

Answer Server::answer(ByteView request, std::chrono::microseconds since_start) {
    Bytes packet;
    if (state_ == ServerState::running) {
        RequestFields fields(request);
        since_start_ = since_start;
        const auto tag = static_cast<RequestTag>(fields.byte());
        polls_ = tag == RequestTag::pollkey ? polls_ : 0;
        const Reply reply = reply_to(tag, fields);
        if (state_ != ServerState::waits_for_input)
            packet = fields.good() ? reply.packet() : failure().packet();
    }
    return {.reply = std::move(packet), .state = state_, .exit = exit_};
}

void Server::finish() {
    if (const std::string rest = visible_.end(); !rest.empty())
        terminal_.write(rest);
}

/// Performs the request. answer() checks afterwards whether a field of the request was missing. A missing field has the
/// value 0 or "" here, and with such a value a request changes nothing.
Reply Server::reply_to(RequestTag tag, RequestFields& fields) {
    switch (tag) {
    case RequestTag::open: return open(fields);
    case RequestTag::remove: return Reply::success_if(folder_.remove(fields.text()));
    case RequestTag::rename: {
        const std::string_view from = fields.text();
        return Reply::success_if(folder_.rename(from, fields.text()));
    }
    case RequestTag::getkey: return key(terminal_.wait_for_key());
    case RequestTag::pollkey: return poll_key();
    case RequestTag::getenv: {
        const auto found = options_.environment.find(fields.text());
        return found != options_.environment.end() ? success().text(found->second) : failure();
    }
    case RequestTag::time: return time();
    case RequestTag::system: return failure();
    case RequestTag::exit: return exit(fields);
    case RequestTag::commandline:
        return success().text(fields.byte() == 0 ? options_.command_line : options_.whole_command_line);
    case RequestTag::core: return core(fields);
    case RequestTag::version: return success().byte(10).byte(4).byte(4).byte(2); // 1.0, Sun-3, SunOS, B008
    default: return reply_for_stream(tag, fields);
    }
}

Reply Server::reply_for_stream(RequestTag tag, RequestFields& fields) {
    if (tag < RequestTag::close || tag > RequestTag::isatty)
        return Reply(Result::not_implemented);
    const std::int32_t number = fields.word();
    Stream* stream = streams_.find(number);
    if (!stream)
        return failure();
    if (number == 0 && stream->at_end() && ++at_end_ >= most_requests_at_end)
        state_ = ServerState::waits_for_input;
    switch (tag) {
    case RequestTag::close: return Reply::success_if(streams_.close(number));
    // At the end of the stream, the reply is success and "".
    case RequestTag::read: return success().text(stream->read(limited(fields.count())));
    case RequestTag::getblock: return get_block(*stream, limited(fields.count()));
    case RequestTag::gets: return get_line(*stream, limited(fields.count()));
    case RequestTag::write: return success().count(stream->write(fields.text()));
    case RequestTag::putblock: return put_block(*stream, fields.text());
    case RequestTag::puts: {
        const std::string_view line = fields.text();
        return fields.good() ? put_line(*stream, line) : failure();
    }
    case RequestTag::seek: {
        const std::int32_t offset = fields.word();
        return Reply::success_if(stream->seek(offset, fields.word()));
    }
    case RequestTag::tell: return position_of(*stream);
    case RequestTag::eof: // pollkey may have found the end of standard input before a stream did
        return Reply::success_if(stream->at_end() || (number == 0 && was_out_of_keys_));
    case RequestTag::ferror: return error_of(*stream);
    case RequestTag::isatty: return success().byte(stream->is_terminal() ? 1 : 0);
    default: return success(); // flush: output is never held back
    }
}

Reply Server::open(RequestFields& fields) {
    const std::string_view name = fields.text();
    const std::uint8_t type = fields.byte();
    const std::uint8_t mode = fields.byte();
    if (type < 1 || type > 2 || mode < 1 || mode > 6) // binary or text, which are the same here
        return failure();
    const std::optional<std::int32_t> stream = streams_.open(name, static_cast<OpenMode>(mode));
    return stream ? success().word(*stream) : failure();
}

Reply Server::key(std::optional<std::uint8_t> key) {
    if (!key)
        state_ = ServerState::waits_for_input;
    return key ? success().byte(*key) : failure();
}

Reply Server::poll_key() {
    const std::optional<std::uint8_t> key = terminal_.pressed_key();
    const bool is_out_of_keys = !key && terminal_.at_end();
    was_out_of_keys_ |= is_out_of_keys;
    polls_ = is_out_of_keys ? polls_ + 1 : 0;
    if (polls_ >= most_polls)
        state_ = ServerState::waits_for_input;
    return key ? success().byte(*key) : failure();
}

/// Replies with local time and universal time. They are equal, because the host's time zone must not change a run.
Reply Server::time() const {
    const auto now = std::chrono::floor<std::chrono::seconds>(options_.date + since_start_).time_since_epoch().count();
    return success().word(static_cast<std::int32_t>(now)).word(static_cast<std::int32_t>(now));
}

Reply Server::core(RequestFields& fields) const {
    const auto begin = static_cast<std::uint32_t>(fields.word());
    const std::size_t most = limited(fields.count());
    if (!options_.core || begin >= options_.core->size())
        return failure();
    const ByteView rest = ByteView(*options_.core).subspan(begin);
    return success().text({reinterpret_cast<const char*>(rest.data()), std::min(most, rest.size())});
}

Reply Server::exit(RequestFields& fields) {
    constexpr std::int32_t usual = 999'999'999; // success; the negative number is failure
    const std::int32_t status = fields.word();
    if (!fields.good())
        return failure();
    state_ = ServerState::exited;
    exit_ = status == usual ? 0 : status == -usual ? 1 : status;
    finish();
    return success();
}

} // namespace placedpar::iserver
