#pragma once

#include "store/database.hpp"
#include "store/file_lock.hpp"

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

/// Makes a whole copy of an open state file, which has its path with a suffix until it is published; gives its path.
/// This and publish() throw UserError or DatabaseError.
std::filesystem::path copy_state_file(store::Database& from, const std::filesystem::path& path);
/// Likewise, from all the bytes of one.
std::filesystem::path write_state_file(const std::string& bytes, const std::filesystem::path& path);
/// Gives the file its name, on the disk, unless another has come to have it meanwhile.
void publish(const std::filesystem::path& made, const std::filesystem::path& path);

/// Throws UserError when the path cannot be that of a state file: a folder, a device, one whose parts are left over.
void require_path_of_file(const std::filesystem::path& path);

/// Is this a state file of ours, by its first bytes? Throws OtherFile, or std::runtime_error.
void require_identity(const store::FileLock& file);

/// Throws std::runtime_error when SQLite finds damage, or the tables are not ours.
void require_integrity(store::Database& database);

} // namespace placedpar::monitor
