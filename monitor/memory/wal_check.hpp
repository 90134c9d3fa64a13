#pragma once

#include <filesystem>
#include <string>

namespace placedpar::monitor {

/// Has the write-ahead log of a database (its path with "-wal") lost anything that was committed? SQLite stops reading
/// it at the first frame whose checksum is wrong, and says nothing: what was committed behind it is gone.
///
/// A kill leaves whole frames, a loss of power may spoil those of the last transaction, which nobody was told of. So
/// one spoilt transaction at the end is named in the sentence that is given, "" when there is none, and with more the
/// file is damaged: throws std::runtime_error saying how.
///
/// Not seen here: a log that was cut between two transactions, or taken away (mark.hpp).
std::string check_wal(const std::filesystem::path& database);

} // namespace placedpar::monitor
