#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::web {

/// Returns the host in the "Host" field of a request, or in an option, without its port. The result is a name in lower
/// case, or an address in its shortest form without brackets. An IPv4 address inside IPv6 becomes IPv4. Returns nullopt
/// if the field is neither a name nor an address.
std::optional<std::string> host_in(std::string_view field);

/// The host names under which browsers may use the service; the service refuses all others. Otherwise an attacker with
/// a web site could let the site's name resolve to this computer. A page of that site could then read the service's
/// answers (DNS rebinding).
class HostNames {
public:
    /// Accepts the address at which the service listens, and further names such as a proxy's. Also accepts "localhost"
    /// if the address is loopback or unspecified, and this computer's name if the address is not loopback. Throws
    /// UserError if a name is not a host name.
    HostNames(const std::string& address, const std::vector<std::string>& further);

    /// Returns whether the host is accepted. `here`, the local address of the connection, is accepted, too.
    bool has(const std::string& host, const std::string& here) const { return host == here || names_.contains(host); }

private:
    std::set<std::string> names_;
};

} // namespace placedpar::web
