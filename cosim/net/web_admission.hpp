// Access control of a server of web pages on this machine: who may read a page, and who may open its WebSocket.
//
// A browser lets every page of the internet send requests to 127.0.0.1. So the address of the page has the token, the
// host must be this machine (a name of an attacker can point to 127.0.0.1), and a request that another page has made is
// refused, even with the token.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace armature::cosim {

struct WebRequest {
  std::string_view method;
  std::string_view target;                   // `/TOKEN/`, `/TOKEN/socket`
  std::string_view host;                     // the header Host; empty: there is none
  std::optional<std::string_view> origin{};  // the header Origin
  bool opens_socket = false;                 // it asks for a WebSocket
};

struct WebAdmission {
  unsigned status = 200;     // of HTTP; not 200: the request is refused
  std::string_view place{};  // what follows `/TOKEN/`, without a query
  std::string_view why{};    // a sentence for the person, if the request is refused
};

// Says what a second page is told: one at a time drives the arm.
inline constexpr std::string_view kBusyPage = "another page has the arm; one page at a time";

// `http://127.0.0.1:PORT/TOKEN/`
[[nodiscard]] std::string page_address(std::uint16_t port, std::string_view token);

// A request that opens a socket must have an Origin: a browser always sends one.
[[nodiscard]] WebAdmission admit_web_request(const WebRequest& request, std::uint16_t port, std::string_view token);

}  // namespace armature::cosim
