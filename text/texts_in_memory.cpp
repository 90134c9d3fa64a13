#include "text/texts_in_memory.hpp"

#include <utility>

namespace placedpar {

namespace {

thread_local const TextsInMemory* texts_of_thread = nullptr;

/// Returns a name of the file that does not depend on how its path is written.
std::string key_of(const std::filesystem::path& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto result = std::filesystem::weakly_canonical(absolute, error);
    return error ? path.string() : result.string();
}

} // namespace

void TextsInMemory::put(const std::filesystem::path& path, std::string text) {
    texts_.insert_or_assign(key_of(path), std::move(text));
}

void TextsInMemory::remove(const std::filesystem::path& path) { texts_.erase(key_of(path)); }

const std::string* TextsInMemory::find(const std::filesystem::path& path) const {
    const auto found = texts_.empty() ? texts_.end() : texts_.find(key_of(path));
    return found == texts_.end() ? nullptr : &found->second;
}

ReadsFromMemory::ReadsFromMemory(const TextsInMemory& texts) { texts_of_thread = &texts; }
ReadsFromMemory::~ReadsFromMemory() { texts_of_thread = nullptr; }

const TextsInMemory* texts_of_this_thread() { return texts_of_thread; }

const std::string* text_in_memory(const std::filesystem::path& path) {
    return texts_of_thread ? texts_of_thread->find(path) : nullptr;
}

bool names_file(const std::filesystem::path& path) {
    std::error_code error;
    return text_in_memory(path) != nullptr || std::filesystem::is_regular_file(path, error);
}

} // namespace placedpar
