#pragma once

#include "runtime/transputer/model.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace placedpar::transputer {

static_assert(std::endian::native == std::endian::little, "words of a transputer are stored as the host stores them");

/// The memory of an emulated transputer: bytes from address MostNeg on, all 0 before the boot. The host provides a page
/// of memory when the page is first used. An offset is a distance from MostNeg.
class NodeMemory {
public:
    /// Size of the pages for which flags are kept. When the program writes to a page, decoded instructions of the page
    /// are discarded, and the old contents of the page are saved if needed.
    static constexpr Word page_bytes = 256;

    /// Throws std::invalid_argument unless 2048 <= bytes < 4 GB and bytes is a multiple of 256. Throws std::bad_alloc
    /// if the host has too little memory. `bytes_on_chip`: size of the memory on the chip, which hides the first bytes
    /// of the external memory. Programs can reach these hidden bytes at addresses that wrap round.
    NodeMemory(std::uint64_t bytes, Word bytes_on_chip) : size_(static_cast<Word>(bytes)), hidden_(bytes_on_chip) {
        if (bytes < 2048 || bytes > 0xffff'ff00 || bytes % page_bytes != 0)
            throw std::invalid_argument("a transputer's memory has 2048 bytes to 4 Gbyte, in steps of 256");
        // There is an additional page, because a real at the end of the memory is read as a whole.
        bytes_.reset(static_cast<std::uint8_t*>(std::calloc(pages() * page_bytes, 1)));
        pages_.reset(static_cast<std::uint8_t*>(std::calloc(pages(), 1)));
        if (!bytes_ || !pages_)
            throw std::bad_alloc();
    }

    static constexpr Word offset_of(Word address) { return address - most_negative; }
    Word size() const { return size_; }
    /// Returns the offset to which an offset outside of the memory wraps round. The result is in the memory, or beyond
    /// its end, where the hidden bytes are stored.
    Word wrapped(Word offset) const {
        offset %= size_;
        return offset < hidden_ ? size_ + offset : offset;
    }
    /// Does the same as wrapped(), but leaves an offset in the memory unchanged.
    Word wrapped_or_not(Word offset) const { return offset < size_ ? offset : wrapped(offset); }
    /// Returns the end of the memory if `place` is in the memory, otherwise the end of the hidden bytes after it.
    Word end_around(Word place) const { return place < size_ ? size_ : size_ + hidden_; }
    bool holds(Word offset, Word bytes) const { return offset <= size_ && bytes <= size_ - offset; }

    std::uint8_t* data() { return bytes_.get(); }
    const std::uint8_t* data() const { return bytes_.get(); }
    /// Returns a number for each page: not 0 if the caller must prepare a write to the page (must_prepare()).
    const std::uint8_t* page_flags() const { return pages_.get(); }
    /// Returns whether the caller must discard decoded instructions or call save() before it writes these bytes.
    /// REQUIRES: the memory holds the bytes.
    bool must_prepare(Word offset) const { return pages_[offset / page_bytes] != 0; }
    bool must_prepare(Word offset, Word bytes) const {
        for (Word page = offset / page_bytes; page <= (offset + bytes - 1) / page_bytes; ++page)
            if (pages_[page])
                return true;
        return false;
    }
    /// Returns whether instructions of the pages of these bytes may be decoded. REQUIRES: the memory holds the bytes,
    /// and bytes > 0.
    bool has_code(Word offset, Word bytes) const {
        for (Word page = offset / page_bytes; page <= (offset + bytes - 1) / page_bytes; ++page)
            if (pages_[page] & code)
                return true;
        return false;
    }
    void note_code(Word page, bool has_code) {
        pages_[page] = static_cast<std::uint8_t>((pages_[page] & ~code) | (has_code ? code : 0));
    }

    /// Saves the contents until the next call of keep() or let_go(), so that go_back() can restore them. A page is
    /// copied only when it is written to.
    void keep() {
        if (std::exchange(has_kept_, true))
            mark_written();
        else
            for (std::size_t page = 0; page < pages(); ++page)
                pages_[page] |= unsaved;
        keeps_ = true;
    }
    void let_go() { keeps_ = false; }
    /// Saves the pages of bytes that will be written. REQUIRES: the memory holds the bytes, and bytes > 0.
    void save(Word offset, Word bytes) {
        for (Word page = offset / page_bytes; page <= (offset + bytes - 1) / page_bytes; ++page)
            if (pages_[page] & unsaved)
                save_page(page);
    }
    /// Restores the saved contents. Calls `changes(offset, bytes)` for each word whose contents change. REQUIRES:
    /// keep() was called, and neither let_go() nor go_back() was called after it.
    template <class F>
    void go_back(F changes) {
        for (std::size_t i = 0; i < copies_.size(); ++i)
            for (Word at = 0; at < page_bytes; at += 4) {
                std::uint8_t* const now = &bytes_[std::size_t{written_[i]} * page_bytes + at];
                if (std::memcmp(now, &copies_[i][at], 4) == 0)
                    continue;
                std::memcpy(now, &copies_[i][at], 4);
                changes(written_[i] * page_bytes + at, Word{4});
            }
        mark_written();
        keeps_ = false;
    }

    /// REQUIRES: holds(offset, 4).
    Word word(Word offset) const {
        Word result;
        std::memcpy(&result, &bytes_[offset], sizeof result);
        return result;
    }
    void set_word(Word offset, Word value) { std::memcpy(&bytes_[offset], &value, sizeof value); }
    std::uint8_t byte(Word offset) const { return bytes_[offset]; }
    std::span<std::uint8_t> bytes(Word offset, Word count) { return {&bytes_[offset], count}; }

private:
    // These are flags of a page. `code`: the page may have decoded instructions. `unsaved`: the page was not written to
    // since keep().
    static constexpr std::uint8_t code = 1, unsaved = 2;

    std::size_t pages() const { return (std::size_t{size_} + hidden_) / page_bytes + 1; }
    void mark_written() {
        for (const Word page : written_)
            pages_[page] |= unsaved;
        written_.clear();
        copies_.clear();
    }
    void save_page(Word page) {
        pages_[page] &= static_cast<std::uint8_t>(~unsaved);
        written_.push_back(page);
        if (keeps_)
            std::memcpy(copies_.emplace_back().data(), &bytes_[std::size_t{page} * page_bytes], page_bytes);
    }

    struct Free {
        void operator()(std::uint8_t* p) const { std::free(p); }
    };
    Word size_, hidden_;
    std::unique_ptr<std::uint8_t[], Free> bytes_, pages_;
    bool has_kept_ = false, keeps_ = false;
    std::vector<Word> written_; ///< pages that are not marked as unsaved; the first of them have copies
    std::vector<std::array<std::uint8_t, page_bytes>> copies_;
};

} // namespace placedpar::transputer
