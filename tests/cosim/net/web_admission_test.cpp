#include "cosim/net/web_admission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace armature::cosim {
namespace {

using testing::HasSubstr;

constexpr std::uint16_t kPort = 4711;
const std::string kPageToken = "0123456789abcdef0123456789abcdef";
const std::string kPlace = "/" + kPageToken + "/";

WebAdmission admit(const WebRequest& request) {
  return admit_web_request(request, kPort, kPageToken);
}

TEST(WebAdmission, TheAddressOfThePageIsServed) {
  EXPECT_EQ(page_address(kPort, kPageToken), "http://127.0.0.1:4711/" + kPageToken + "/");
  for (const char* host : {"127.0.0.1:4711", "localhost:4711"}) {
    const WebAdmission admission = admit({.method = "GET", .target = kPlace, .host = host});
    EXPECT_EQ(admission.status, 200u) << host;
    EXPECT_EQ(admission.place, "");
  }
  EXPECT_EQ(admit({.method = "GET", .target = kPlace + "socket?x=1", .host = "localhost:4711"}).place, "socket");
}

TEST(WebAdmission, WithoutTheTokenNothingIsServed) {
  const std::string other = "1123456789abcdef0123456789abcdef";
  for (const std::string& target :
       {std::string{"/"}, std::string{}, "/" + kPageToken, "/" + kPageToken.substr(1) + "/", "/" + kPageToken + "0/",
        "/" + other + "/", "//" + kPageToken + "/", "/x/" + kPageToken + "/", "/?" + kPageToken + "/",
        std::string{"/0123456789ABCDEF0123456789ABCDEF/"}, std::string{"/socket"}, std::string{"//"}}) {
    const WebAdmission admission = admit({.method = "GET", .target = target, .host = "127.0.0.1:4711"});
    EXPECT_EQ(admission.status, 403u) << target;
    EXPECT_THAT(std::string{admission.why}, HasSubstr("token")) << target;
  }
}

// A name of an attacker may point to 127.0.0.1.
TEST(WebAdmission, AnotherHostIsRefusedEvenWithTheToken) {
  for (const char* host : {"", "127.0.0.1", "localhost", "127.0.0.1:4712", "127.0.0.1:47110", "evil.example:4711",
                           "127.0.0.1:4711.evil.example", "[::1]:4711", "0.0.0.0:4711", "LOCALHOST:4711 "}) {
    const WebAdmission admission = admit({.method = "GET", .target = kPlace, .host = host});
    EXPECT_EQ(admission.status, 403u) << host;
    EXPECT_THAT(std::string{admission.why}, HasSubstr("host")) << host;
  }
}

TEST(WebAdmission, APageOfAnotherOriginIsRefusedEvenWithTheToken) {
  for (const char* origin :
       {"http://evil.example", "null", "", "http://127.0.0.1", "http://127.0.0.1:4712", "https://127.0.0.1:4711",
        "http://localhost:4711", "http://127.0.0.1:4711.evil.example", "http://evil.example/http://127.0.0.1:4711"}) {
    for (const bool socket : {false, true}) {
      const WebAdmission admission = admit({.method = "GET",
                                            .target = kPlace + "socket",
                                            .host = "127.0.0.1:4711",
                                            .origin = origin,
                                            .opens_socket = socket});
      EXPECT_EQ(admission.status, 403u) << origin;
      EXPECT_THAT(std::string{admission.why}, HasSubstr("another page")) << origin;
    }
  }
}

TEST(WebAdmission, ASocketNeedsTheOriginThatABrowserAlwaysSends) {
  const std::string place = kPlace + "socket";
  WebRequest request{.method = "GET", .target = place, .host = "127.0.0.1:4711", .opens_socket = true};
  EXPECT_EQ(admit(request).status, 403u);
  request.origin = "http://127.0.0.1:4711";
  EXPECT_EQ(admit(request).status, 200u);
}

TEST(WebAdmission, OnlyGetIsServed) {
  for (const char* method : {"POST", "PUT", "HEAD", "OPTIONS", "get"}) {
    EXPECT_EQ(admit({.method = method, .target = kPlace, .host = "127.0.0.1:4711"}).status, 405u) << method;
  }
}

}  // namespace
}  // namespace armature::cosim
