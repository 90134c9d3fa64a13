#pragma once

#include "store/database.hpp"
#include "store/file_lock.hpp"

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace placedpar::monitor {

/// Reports an undamaged file that cannot be the state file, because it belongs to another program, version or settings.
/// what() names the remedy.
class OtherFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Creates an empty state file for these settings of the diagnoses. The file gets its name only when its content is on
/// the disk, so that a crash leaves no half-written file of this name. Throws UserError.
void create_state_file(const std::filesystem::path& path, const std::string& settings);

/// Writes `bytes` to a new file and returns the file's name, which is `path` with a suffix. publish() then renames the
/// file. This function and publish() throw UserError.
std::filesystem::path write_state_file(const std::string& bytes, const std::filesystem::path& path);
/// Renames the file `made` to `path`, and returns when the new name is on the disk. Does not replace a file that
/// meanwhile got this name.
void publish(const std::filesystem::path& made, const std::filesystem::path& path);

/// Throws UserError if no state file can have this path. Such a path is, for example, a directory, a device, or a
/// missing file whose journal still exists.
void require_path_of_file(const std::filesystem::path& path);

/// The versions differ in more than one bit, so that one flipped bit cannot turn one version into the other.
inline constexpr std::uint32_t file_version = 4, earlier_file_version = 2;

/// Reads the version of a state file from its first bytes. The result is `file_version` or `earlier_file_version`.
/// Throws OtherFile if the file belongs to another program or has another version, and std::runtime_error if it is not
/// a state file.
std::uint32_t require_identity(const store::FileLock& file);

/// Renames a file of the earlier version and the files that SQLite keeps beside it. Returns a message that tells the
/// operator the new name.
std::string put_aside(const std::filesystem::path& path);
/// Returns the name that put_aside() gives to the file.
std::string place_aside(const std::filesystem::path& path);
/// Returns the message that put_aside() returns.
std::string told_aside(const std::filesystem::path& path);

/// Limits to 62 bits the sum of the rows' checksums, which the file stores in a row of its own, the ledger. A sum shows
/// equal changes of two checksums, which an exclusive or would hide. The rows of messages are not part of the sum.
inline constexpr std::uint64_t sum_mask = (std::uint64_t{1} << 62) - 1;
std::int64_t ledger_checksum(const std::string& settings, std::uint64_t trimmed, std::uint64_t last, std::uint64_t sum);

/// Throws std::runtime_error if SQLite finds damage, or if the database does not have the tables of a state file.
void require_integrity(store::Database& database);

} // namespace placedpar::monitor
