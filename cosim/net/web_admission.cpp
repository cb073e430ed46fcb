#include "cosim/net/web_admission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cosim/net/token.hpp"

namespace armature::cosim {
namespace {

constexpr unsigned kForbidden = 403, kNotAllowed = 405;
constexpr std::array<std::string_view, 2> kHosts{"127.0.0.1", "localhost"};

bool is_this_server(std::string_view host, std::uint16_t port) {
  return std::ranges::any_of(kHosts, [&](std::string_view name) { return host == fmt::format("{}:{}", name, port); });
}

// The page and its requests have the same origin, so they name the host in the same way.
bool is_own_origin(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && origin.substr(kScheme.size()) == host;
}

}  // namespace

std::string page_address(std::uint16_t port, std::string_view token) {
  return fmt::format("http://{}:{}/{}/", kHosts[0], port, token);
}

WebAdmission admit_web_request(const WebRequest& request, std::uint16_t port, std::string_view token) {
  const auto refused = [](unsigned status, std::string_view why) { return WebAdmission{status, {}, why}; };
  if (!is_this_server(request.host, port)) {
    return refused(kForbidden, "the host of this request is not this server: use the address that armature printed");
  }
  if (request.origin ? !is_own_origin(*request.origin, request.host) : request.opens_socket) {
    return refused(kForbidden, "this request comes from another page: only the page of this server may make it");
  }
  std::string_view rest = request.target;
  if (rest.starts_with('/')) rest.remove_prefix(1);
  const std::size_t end = rest.find('/');
  if (end == std::string_view::npos || !same_token(rest.substr(0, end), token)) {
    return refused(kForbidden, "the token is missing or wrong: open the whole address that armature printed");
  }
  if (request.method != "GET") return refused(kNotAllowed, "only GET is served here");
  rest.remove_prefix(end + 1);
  return {.place = rest.substr(0, rest.find('?'))};
}

}  // namespace armature::cosim
