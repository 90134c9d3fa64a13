#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace placedpar {

/// Texts that replace files, such as texts that are open in an editor and not saved.
class TextsInMemory {
public:
    /// Replaces the text of a file, which need not exist.
    void put(const std::filesystem::path&, std::string text);
    void remove(const std::filesystem::path&);
    /// Returns null if there is no text for this file.
    const std::string* find(const std::filesystem::path&) const;

private:
    std::map<std::string, std::string, std::less<>> texts_; ///< by canonical path
};

/// Lets load_source() and names_file() of this thread read texts in memory while this object exists. REQUIRES: the
/// texts outlive this object, and no other object of this class exists in the thread.
class ReadsFromMemory {
public:
    explicit ReadsFromMemory(const TextsInMemory&);
    ~ReadsFromMemory();
    ReadsFromMemory(const ReadsFromMemory&) = delete;
    ReadsFromMemory& operator=(const ReadsFromMemory&) = delete;
};

/// Returns the texts that this thread reads at present; null if it reads only files.
const TextsInMemory* texts_of_this_thread();

/// Returns the text that replaces a file at present; null if the file itself must be read.
const std::string* text_in_memory(const std::filesystem::path&);

/// Returns whether a path names a file or a text in memory. A directory is not a file.
bool names_file(const std::filesystem::path&);

} // namespace placedpar
