#pragma once

#include "store/database.hpp"
#include "store/file_lock.hpp"

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace placedpar::monitor {

/// A whole file, but another's, of another version or of other settings: what() says what to do.
class OtherFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Makes an empty state file, whole: it takes the name when it is on the disk. Throws UserError. `settings` are kept in
/// it.
void create_state_file(const std::filesystem::path& path, const std::string& settings);

/// Makes a state file of all the bytes of one, which has its path with a suffix until it is published; gives its path.
/// This and publish() throw UserError.
std::filesystem::path write_state_file(const std::string& bytes, const std::filesystem::path& path);
/// Gives the file its name, on the disk, unless another has come to have it meanwhile.
void publish(const std::filesystem::path& made, const std::filesystem::path& path);

/// Throws UserError when the path cannot be that of a state file: a folder, a device, one whose parts are left over.
void require_path_of_file(const std::filesystem::path& path);

/// No flipped bit makes one of the other.
inline constexpr std::uint32_t file_version = 4, earlier_file_version = 2;

/// Is this a state file of ours, by its first bytes? Gives its version, one of these two. Throws OtherFile, or
/// std::runtime_error.
std::uint32_t require_identity(const store::FileLock& file);

/// Gives a file of the earlier version, with those beside it, another name; tells the operator which.
std::string put_aside(const std::filesystem::path& path);
/// Returns where put_aside() puts it.
std::string place_aside(const std::filesystem::path& path);
/// Returns what put_aside() does.
std::string told_aside(const std::filesystem::path& path);

/// The ledger's sum of the other rows' checksums, but for messages', is of so many bits. A sum, since two rows that
/// change alike would leave an exclusive or as it was.
inline constexpr std::uint64_t sum_mask = (std::uint64_t{1} << 62) - 1;
std::int64_t ledger_checksum(const std::string& settings, std::uint64_t trimmed, std::uint64_t last, std::uint64_t sum);

/// Throws std::runtime_error when SQLite finds damage, or the tables are not ours.
void require_integrity(store::Database& database);

} // namespace placedpar::monitor
