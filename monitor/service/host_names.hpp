#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// The host in a "Host" field or an option, without its port: a name in small letters, or an address without brackets
/// in its shortest form, one of IPv4 within IPv6 as that of IPv4. None when it is neither.
std::optional<std::string> host_in(std::string_view field);

/// What browsers may call the service. Whoever owns a name can let it lead to this computer, and have his page read
/// what is served under it (DNS rebinding): other names are foreign.
class HostNames {
public:
    /// Takes the address at which the service listens, and further names, such as a proxy's. "localhost" is one where
    /// loopback leads to it, this computer's name where others do. Throws UserError when one is no name.
    HostNames(const std::string& address, const std::vector<std::string>& further);

    /// `here`: the address that the connection came in by, which is one, too.
    bool has(const std::string& host, const std::string& here) const { return host == here || names_.contains(host); }

private:
    std::set<std::string> names_;
};

} // namespace placedpar::monitor
