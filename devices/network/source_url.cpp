#include "devices/network/source_url.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace carom {
namespace {

std::string inQuotes(std::string_view text) { return '\'' + std::string(text) + '\''; }

/// What comes before `mark` and what comes after; all of it and nothing where there is no mark.
std::pair<std::string_view, std::string_view> cut(std::string_view text, char mark) {
  const std::size_t at = std::min(text.find(mark), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

}  // namespace

std::uint32_t SourceUrl::address(const std::string& key) const {
  const auto found = options.find(key);
  if (found == options.end()) return 0;
  if (const auto address = ipv4Of(found->second)) return *address;
  throw std::invalid_argument(key + " is " + inQuotes(found->second) +
                              ", expected an address such as 192.168.1.20");
}

Ipv4 SourceUrl::local() const {
  if (const auto address = ipv4Of(endpoint.host)) return {*address, endpoint.port};
  throw std::invalid_argument(
      inQuotes(endpoint.host) +
      " is no IPv4 address, expected one of this machine, 0.0.0.0 for all of them, or a group");
}

Endpoint readEndpoint(std::string_view text, std::uint16_t defaultPort) {
  const auto [host, port] = cut(text, ':');
  const bool isPlain = !host.empty() && std::all_of(host.begin(), host.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '.' || c == '_';
  });
  if (!isPlain) {
    throw std::invalid_argument(inQuotes(host) + " names no machine, expected a name or an IPv4 address");
  }
  Endpoint endpoint{std::string(host), defaultPort};
  if (host.size() == text.size()) return endpoint;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), endpoint.port);
  if (error != std::errc{} || end != port.data() + port.size() || endpoint.port == 0) {
    throw std::invalid_argument("the port is " + inQuotes(port) + ", expected a number from 1 to 65535");
  }
  return endpoint;
}

SourceUrl readSourceUrl(std::string_view text, std::string_view scheme, std::uint16_t defaultPort,
                        std::span<const std::string_view> optionKeys, std::string_view example) {
  const std::string start = std::string(scheme) + "://";
  if (!text.starts_with(start)) {
    throw std::invalid_argument("source is " + inQuotes(text) + ", expected one such as " +
                                inQuotes(example));
  }
  const auto [place, query] = cut(text.substr(start.size()), '?');
  SourceUrl url{readEndpoint(place, defaultPort), {}};
  for (std::string_view rest = query; !rest.empty();) {
    const auto [option, others] = cut(rest, '&');
    const auto [key, value] = cut(option, '=');
    if (std::find(optionKeys.begin(), optionKeys.end(), key) == optionKeys.end()) {
      std::string known;
      for (const std::string_view optionKey : optionKeys) {
        known += (known.empty() ? "" : " or ") + inQuotes(optionKey);
      }
      throw std::invalid_argument("unknown option " + inQuotes(key) + " in the source, expected " +
                                  (known.empty() ? "none" : known));
    }
    url.options[std::string(key)] = value;
    rest = others;
  }
  return url;
}

}  // namespace carom
