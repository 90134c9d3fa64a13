#include "web/host_names.hpp"

#include "text/user_error.hpp"
#include "web/listener.hpp"

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/host_name.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace placedpar::web {

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

constexpr std::string_view digits = "0123456789",
                           name_letters = "abcdefghijklmnopqrstuvwxyz0123456789-._"; // RFC 3986, 3.2.2, without "%"

bool is_port(std::string_view text) { return text.size() <= 5 && text.find_first_not_of(digits) == text.npos; }

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c; });
    return small;
}

} // namespace

std::optional<std::string> host_in(std::string_view field) {
    bool bracketed = field.starts_with('[');
    std::size_t end = bracketed ? field.find(']') : field.find(':');
    if (bracketed && end == field.npos)
        return std::nullopt;
    std::string_view host = field.substr(bracketed, bracketed ? end - 1 : end);
    std::string_view rest = end == field.npos ? "" : field.substr(end + bracketed);
    if (!rest.empty() && (rest[0] != ':' || !is_port(rest.substr(1))))
        return std::nullopt;
    error_code error;
    asio::ip::address address = asio::ip::make_address(std::string(host), error);
    if (!error && address.is_v6() == bracketed)
        return plain_address(address).to_string();
    std::string name = in_small_letters(host);
    if (name.ends_with('.')) // a final dot stands for the root of the domain name system
        name.pop_back();
    if (bracketed || name.empty() || name.find_first_not_of(name_letters) != name.npos)
        return std::nullopt;
    return name;
}

namespace {

std::string name_of_option(const std::string& typed) {
    for (const std::string& field : {typed, fmt::format("[{}]", typed)})
        if (auto name = host_in(field))
            return *name;
    throw UserError(fmt::format(
        "--host-name {}: expected the name of a computer, such as digger.example, or an IP address", typed));
}

} // namespace

HostNames::HostNames(const std::string& address, const std::vector<std::string>& further) {
    error_code error;
    asio::ip::address listens = asio::ip::make_address(address, error);
    if (!error)
        names_.insert(plain_address(listens).to_string());
    if (listens.is_loopback() || listens.is_unspecified())
        names_.insert("localhost");
    if (!listens.is_loopback())
        if (auto name = host_in(asio::ip::host_name(error)))
            names_.insert(*name);
    for (const std::string& each : further)
        names_.insert(name_of_option(each));
}

} // namespace placedpar::web
