#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace placedpar {

/// Holds texts that are read in place of files, such as texts that are open in an editor and not saved.
class TextsInMemory {
public:
    /// Sets the text that is read in place of a file. The file need not exist.
    void put(const std::filesystem::path&, std::string text);
    void remove(const std::filesystem::path&);
    /// Returns null if there is no text for this file.
    const std::string* find(const std::filesystem::path&) const;

private:
    std::map<std::string, std::string, std::less<>> texts_; ///< key: canonical path of the file
};

/// Makes load_source() and names_file() use these texts in place of files. This holds for the thread that makes the
/// object, as long as the object exists. REQUIRES: the texts outlive the object; no other object of this class exists
/// in the thread.
class ReadsFromMemory {
public:
    explicit ReadsFromMemory(const TextsInMemory&);
    ~ReadsFromMemory();
    ReadsFromMemory(const ReadsFromMemory&) = delete;
    ReadsFromMemory& operator=(const ReadsFromMemory&) = delete;
};

/// Returns the texts of this thread's ReadsFromMemory; null if the thread has none.
const TextsInMemory* texts_of_this_thread();

/// Returns the text that this thread reads in place of a file; null if it reads the file itself.
const std::string* text_in_memory(const std::filesystem::path&);

/// Returns whether a path names a file or a text in memory. A directory is not a file.
bool names_file(const std::filesystem::path&);

} // namespace placedpar
