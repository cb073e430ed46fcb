// The pendant's end of messages: reads the present message of the controller's program, page by page.
//
// The message may be replaced while its pages are read. So its header is read again at the end; when it is another one,
// all is read again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "controller/pendant/protocol/message_pages.hpp"

namespace armature::cosim {

struct PendantMessage {
  pendant::MessageHeader header{};
  std::int32_t place = 0;  // in the program, as the page `line` has it
  std::string text;
};

// `message: "Hello"`, `alarm: no part`; `no message`
[[nodiscard]] std::string message_text(const PendantMessage& message);

class MessageReader {
 public:
  // Reads the message, from its header on.
  void begin();
  // The same if this page `message`, from the telemetry, is not that of the message under way or read last.
  void on_telemetry(std::int32_t header_page);

  // The page to read next; none while there is nothing to do.
  [[nodiscard]] std::optional<std::uint8_t> next() const;
  // The value of the page next().
  void on_page(std::int32_t value);

  // The last complete message; none before the first.
  [[nodiscard]] const std::optional<PendantMessage>& message() const { return message_; }
  // The number of complete messages that were read.
  [[nodiscard]] std::int64_t read() const { return read_; }

 private:
  enum class Step : std::uint8_t { kIdle, kHeader, kPlace, kText, kHeaderAgain };

  void take_header(std::int32_t page);
  [[nodiscard]] std::size_t length() const;

  Step step_ = Step::kIdle;
  std::int32_t header_page_ = 0;  // of the message under way or read last
  PendantMessage next_;           // under way
  std::optional<PendantMessage> message_;
  std::int64_t read_ = 0;
};

}  // namespace armature::cosim
