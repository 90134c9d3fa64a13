#include "explore/study/study_keys.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

std::string range_of(const StudyKey& key) {
    return key.form != StudyKey::whole_number ? ""
           : key.most == StudyKey::no_most    ? fmt::format(", {} or more", key.least)
                                              : fmt::format(" from {} to {}", key.least, key.most);
}

} // namespace

std::string print_study_key(const StudyKey& key) {
    return fmt::format("{}: {}{}\n{}\n", key.name, key.form, range_of(key), key.about);
}

} // namespace placedpar
