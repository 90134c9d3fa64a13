#include "editor/language/completion.hpp"
#include "editor/language/navigation.hpp"
#include "editor/language/study_text.hpp"
#include "explore/study/study_keys.hpp"
#include "explore/study/study_names.hpp"
#include "report/cell.hpp"
#include "text/load_source.hpp"
#include "text/positions.hpp"
#include "text/texts_in_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

namespace placedpar::editor {

namespace {

using NamesByText = std::map<std::string, StudyName>;

/// Describes a place in a study, a TOML file about experiments with a netlist: the place to which the keys before a
/// word lead.
struct StudyPlace {
    StudyPart part = StudyPart::whole;
    std::optional<StudyKey> key = {}; ///< the last of these keys that a study can have
    std::string name = ""; ///< the parts of a netlist's name after this key, each with a dot: "master.trials."
};

bool has_names(StudyPart part) { return study_keys(part).empty(); }

std::optional<StudyKey> key_of(StudyPart part, const std::string& name) {
    for (const StudyKey& each : study_keys(part))
        if (each.name == name)
            return each;
    return std::nullopt;
}

/// Follows the keys before a word, from the top of the study. Returns nothing if a key is unknown, or if its value has
/// no members.
std::optional<StudyPlace> place_of(const StudyWord& word) {
    StudyPlace place;
    for (std::size_t i = 0; i < word.path.size(); ++i) {
        if (has_names(place.part)) {
            place.name += word.path[i] + ".";
            continue;
        }
        place.key = key_of(place.part, word.path[i]);
        if (!place.key || (!place.key->members && (word.is_key || i + 1 < word.path.size())))
            return std::nullopt;
        place.part = place.key->members.value_or(place.part);
    }
    return place;
}

bool is_in_measure(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) != 0 || byte >= 0x80 || std::string_view("_.[]").find(c) != std::string_view::npos;
}

std::string without_subscripts(std::string_view text) {
    std::string name;
    int depth = 0;
    for (const char c : text) {
        depth += c == '[' ? 1 : 0;
        if (depth == 0)
            name += c;
        depth -= c == ']' && depth > 0 ? 1 : 0;
    }
    return name;
}

/// Returns the name in an expression that contains the character at an offset.
std::string name_around(const std::string& text, std::size_t offset) {
    std::size_t first = std::min(offset, text.size()), end = first;
    while (first > 0 && is_in_measure(text[first - 1]))
        --first;
    while (end < text.size() && is_in_measure(text[end]))
        ++end;
    return without_subscripts(std::string_view(text).substr(first, end - first));
}

std::string last_part(const std::string& name) { return name.substr(name.rfind('.') + 1); }

const NamesByText& names_under(StudyPart part, const StudyNames& names) {
    static const NamesByText none;
    return part == StudyPart::settings ? names.settings : part == StudyPart::programs ? names.programs : none;
}

/// Returns the netlist's names that a value of the study can use. In an expression, names have no dots: `trials` means
/// `master.trials`.
NamesByText names_for(StudyWords words, const StudyNames& names) {
    NamesByText all;
    if (words == StudyWords::conditions || words == StudyWords::figures)
        for (const auto& [name, meaning] : names.settings)
            all.emplace(last_part(name), meaning);
    if (words == StudyWords::measures || words == StudyWords::figures)
        all.insert(names.measures.begin(), names.measures.end());
    if (words == StudyWords::figures)
        for (const auto& [name, meaning] : names.measures)
            all.emplace(last_part(name), meaning);
    return all;
}

const StudyWord* word_at(const StudyText& text, const Location& at) {
    const std::size_t offset = offset_of(at);
    const auto found = std::ranges::find_if(
        text.words, [&](const StudyWord& each) { return each.first <= offset && offset <= each.end; });
    return found == text.words.end() ? nullptr : &*found;
}

/// Returns the meaning of the word at a place, if it is a name of the netlist; nothing otherwise.
std::optional<StudyName> meaning_of(const StudyWord& word, const StudyPlace& place, const StudyNames& names,
                                    std::size_t offset) {
    if (!word.is_key && !place.key)
        return std::nullopt;
    const NamesByText known = word.is_key ? names_under(place.part, names) : names_for(place.key->words, names);
    const auto found = known.find(word.is_key ? without_subscripts(place.name + word.text)
                                              : name_around(word.text, offset - word.first));
    return found == known.end() ? std::nullopt : std::optional(found->second);
}

/// Collects the words that an editor can offer at the end of a text.
class StudyCompletions {
public:
    StudyCompletions(const StudyText& before, const StudyNames& names, const Catalogue& catalogue)
        : before_(before), names_(names), catalogue_(catalogue) {}

    std::vector<Completion> take() {
        const std::optional<StudyPlace> place = place_of(before_.last);
        if (before_.in_header)
            add_headers();
        else if (place && before_.last.is_key)
            add_keys(*place);
        else if (place && place->key)
            add_values(*place);
        return std::move(found_);
    }

private:
    void add_headers() {
        for (const StudyKey& each : study_keys(StudyPart::whole))
            if (each.members)
                add(each);
    }

    void add_keys(const StudyPlace& place) {
        for (const StudyKey& each : study_keys(place.part))
            add(each);
        if (place.part == StudyPart::prices)
            add_prices();
        add_names(names_under(place.part, names_), place.name + before_.last.text);
    }

    void add(const StudyKey& key) {
        found_.push_back(
            {std::string(key.name), Completion::Kind::parameter, std::string(key.form), std::string(key.about)});
    }

    void add_prices() {
        found_.push_back({"link", Completion::Kind::parameter});
        for (const auto& each : catalogue_.node_types())
            found_.push_back({each.first, Completion::Kind::type});
    }

    void add_values(const StudyPlace& place) {
        const std::string typed = name_around(before_.last.text, before_.last.text.size());
        if (place.part == StudyPart::programs)
            add_kinds();
        else if (const auto set = names_.settings.find(place.name.substr(0, place.name.rfind('.')));
                 place.part == StudyPart::settings && set != names_.settings.end())
            add_texts(set->second.choices);
        add_names(names_for(place.key->words, names_), typed);
        add_texts(words_of(place.key->words));
    }

    std::vector<std::string> words_of(StudyWords words) const {
        std::vector<std::string> texts;
        if (words == StudyWords::truths)
            texts = {"true", "false"};
        if (words == StudyWords::judges)
            for (const Judge each : every_judge)
                texts.emplace_back(name_of(each));
        if (words == StudyWords::origins)
            for (const Origin each : every_origin)
                texts.emplace_back(name_of(each));
        if (words == StudyWords::tables)
            for (const StudyWord& each : before_.words)
                if (!each.is_key && each.path == std::vector<std::string>{"table", "name"})
                    texts.push_back(each.text);
        return texts;
    }

    void add_kinds() {
        for (const auto& [name, kind] : catalogue_.kinds())
            found_.push_back({quoted(name), Completion::Kind::kind, "", kind.about});
    }

    void add_texts(const std::vector<std::string>& texts) {
        for (const std::string& each : texts)
            found_.push_back({each == "true" || each == "false" ? each : quoted(each), Completion::Kind::value});
    }

    /// Adds the names that begin with the typed text up to its last dot, without this beginning.
    void add_names(const NamesByText& names, const std::string& typed) {
        const std::string parts = without_subscripts(typed.substr(0, typed.rfind('.') + 1));
        for (const auto& [name, meaning] : names)
            if (name.starts_with(parts))
                found_.push_back({before_.last.is_key ? name.substr(parts.size()) : quoted(name.substr(parts.size())),
                                  Completion::Kind::parameter, meaning.about.substr(0, meaning.about.find('\n'))});
    }

    std::string quoted(const std::string& text) const { return before_.in_quotes ? text : fmt::format("\"{}\"", text); }

    const StudyText& before_;
    const StudyNames& names_;
    const Catalogue& catalogue_;
    std::vector<Completion> found_;
};

Location location_at(const std::shared_ptr<const SourceFile>& file, std::size_t offset) {
    const std::string_view before = std::string_view(file->text()).substr(0, offset);
    const auto start = before.rfind('\n') + 1; // 0 if there is none
    return {file, static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1, offset - start + 1};
}

/// Returns the place of the name of a table; nothing if there is no table of this name.
std::optional<Location> table_named(const StudyText& text, const std::string& name, const Location& at) {
    for (const StudyWord& each : text.words)
        if (!each.is_key && each.text == name && each.path == std::vector<std::string>{"table", "name"})
            return location_at(at.file, each.first);
    return std::nullopt;
}

std::optional<Location> file_named(const std::string& name, const Location& at) {
    const std::filesystem::path path = std::filesystem::path(at.file->path()).parent_path() / name;
    return names_file(path) ? std::optional(Location{load_source(path).file, 1, 1}) : std::nullopt;
}

} // namespace

std::vector<Completion> complete_study(const StudyText& before, const StudyNames& names, const Catalogue& catalogue) {
    return before.in_comment ? std::vector<Completion>() : StudyCompletions(before, names, catalogue).take();
}

std::string hover_study(const StudyText& text, const StudyNames& names, const Location& at) {
    const StudyWord* const word = word_at(text, at);
    const auto place = word ? place_of(*word) : std::nullopt;
    if (!place)
        return "";
    if (word->is_key && !has_names(place->part)) {
        const auto key = key_of(place->part, word->text);
        return key ? print_study_key(*key) : "";
    }
    const auto meaning = meaning_of(*word, *place, names, offset_of(at));
    return meaning ? meaning->about : "";
}

std::optional<Location> definition_in_study(const StudyText& text, const StudyNames& names, const Location& at) {
    const StudyWord* const word = word_at(text, at);
    const auto place = word ? place_of(*word) : std::nullopt;
    if (!place)
        return std::nullopt;
    if (!word->is_key && place->key && place->key->name == "netlist")
        return file_named(word->text, at);
    if (!word->is_key && place->key && place->key->words == StudyWords::tables)
        return table_named(text, word->text, at);
    const auto meaning = meaning_of(*word, *place, names, offset_of(at));
    return meaning && meaning->at.file ? std::optional(meaning->at) : std::nullopt;
}

} // namespace placedpar::editor
