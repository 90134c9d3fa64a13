#include "iserver/host_folder.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace placedpar::iserver {

namespace {

/// The name of a file, with the open folder that contains the file.
struct Entry {
    OpenFile folder; ///< no file if the name is refused, or a folder is missing
    std::string name;
};

bool is_control_character(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

bool is_good(std::string_view name) {
    if (name.empty() || name.size() > HostFolder::longest_name || name.front() == '/')
        return false;
    const bool has_drive = name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
    return !has_drive && std::ranges::none_of(name, is_control_character);
}

/// Opens the folders in a name one after another, without following a link.
Entry find_entry(const OpenFile& top, std::string_view name) {
    Entry entry{.folder = OpenFile(top ? ::fcntl(top.descriptor(), F_DUPFD_CLOEXEC, 0) : -1), .name = ""};
    if (!is_good(name))
        return {};
    for (;;) {
        const std::size_t slash = name.find('/');
        entry.name = name.substr(0, slash);
        if (entry.name == "..")
            return {};
        if (slash == name.npos)
            return entry;
        name.remove_prefix(slash + 1);
        if (!entry.name.empty())
            entry.folder = OpenFile(
                ::openat(entry.folder.descriptor(), entry.name.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    }
}

enum class Found { nothing, regular_file, other };

Found what_is(const Entry& entry) {
    struct stat status;
    if (::fstatat(entry.folder.descriptor(), entry.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT ? Found::nothing : Found::other;
    return S_ISREG(status.st_mode) ? Found::regular_file : Found::other;
}

int flags_of(OpenMode mode) {
    switch (mode) {
    case OpenMode::read: return O_RDONLY;
    case OpenMode::write: return O_WRONLY | O_CREAT;
    case OpenMode::append: return O_WRONLY | O_CREAT | O_APPEND;
    case OpenMode::update: return O_RDWR;
    case OpenMode::write_and_read: return O_RDWR | O_CREAT;
    case OpenMode::append_and_read: return O_RDWR | O_CREAT | O_APPEND;
    }
    return O_RDONLY;
}

} // namespace

OpenFile::~OpenFile() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

HostFolder::HostFolder(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
    if (!folder_)
        throw UserError(fmt::format("cannot use \"{}\" as the host's folder: {}", folder.string(),
                                    std::generic_category().message(errno)));
}

/// The file is checked before and after it is opened, because another program may replace it in between. If it has
/// become a pipe, O_NONBLOCK prevents a wait for the pipe's other end. For a regular file, O_NONBLOCK has no effect.
OpenFile HostFolder::open(std::string_view name, OpenMode mode, bool& created) const {
    const Entry entry = find_entry(folder_, name);
    const Found found = entry.folder ? what_is(entry) : Found::other;
    if (found == Found::other)
        return {};
    created = found == Found::nothing;
    OpenFile file(::openat(entry.folder.descriptor(), entry.name.c_str(),
                           flags_of(mode) | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666));
    struct stat status;
    if (!file || ::fstat(file.descriptor(), &status) != 0 || !S_ISREG(status.st_mode))
        return {};
    const bool emptied = mode == OpenMode::write || mode == OpenMode::write_and_read;
    return !emptied || ::ftruncate(file.descriptor(), 0) == 0 ? std::move(file) : OpenFile{};
}

bool HostFolder::remove(std::string_view name) const {
    const Entry entry = find_entry(folder_, name);
    return entry.folder && what_is(entry) == Found::regular_file &&
           ::unlinkat(entry.folder.descriptor(), entry.name.c_str(), 0) == 0;
}

bool HostFolder::rename(std::string_view from, std::string_view to) const {
    const Entry old_entry = find_entry(folder_, from);
    const Entry new_entry = find_entry(folder_, to);
    return old_entry.folder && new_entry.folder && what_is(old_entry) == Found::regular_file &&
           what_is(new_entry) != Found::other &&
           ::renameat(old_entry.folder.descriptor(), old_entry.name.c_str(), new_entry.folder.descriptor(),
                      new_entry.name.c_str()) == 0;
}

} // namespace placedpar::iserver
