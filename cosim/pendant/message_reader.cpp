#include "cosim/pendant/message_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cosim/text/printable.hpp"

namespace armature::cosim {

using pendant::MessageKind;
using pendant::Page;

std::string message_text(const PendantMessage& message) {
  const std::string text = printable(message.text);
  switch (message.header.kind) {
    case MessageKind::kNone:
      break;
    case MessageKind::kMessage:
      return fmt::format("message: \"{}\"", text);
    case MessageKind::kAlarm:
      return "alarm: " + text;
    case MessageKind::kStopped:
      return "stopped: the arm did not carry out this line";
  }
  return "no message";
}

void MessageReader::begin() {
  step_ = Step::kHeader;
}

void MessageReader::on_telemetry(std::int32_t header_page) {
  if (header_page != header_page_) begin();
}

std::optional<std::uint8_t> MessageReader::next() const {
  const auto page = [](Page first, std::size_t offset = 0) {
    return static_cast<std::uint8_t>(static_cast<std::size_t>(first) + offset);
  };
  switch (step_) {
    case Step::kIdle:
      break;
    case Step::kHeader:
    case Step::kHeaderAgain:
      return page(Page::kMessage);
    case Step::kPlace:
      return page(Page::kMessageLine);
    case Step::kText:
      return page(Page::kMessageText, next_.text.size() / pendant::kCharactersOfPage);
  }
  return std::nullopt;
}

std::size_t MessageReader::length() const {
  return std::min<std::size_t>(next_.header.length, pendant::kMaxMessageText);
}

void MessageReader::take_header(std::int32_t page) {
  header_page_ = page;
  next_ = {.header = pendant::message_header(page), .place = 0, .text = {}};
  step_ = Step::kPlace;
}

void MessageReader::on_page(std::int32_t value) {
  switch (step_) {
    case Step::kIdle:
      return;
    case Step::kHeader:
      return take_header(value);
    case Step::kPlace:
      next_.place = value;
      break;
    case Step::kText: {
      const auto characters = pendant::characters_of(value);
      next_.text.append(characters.data(), characters.size());
      break;
    }
    case Step::kHeaderAgain:
      if (value != header_page_) return take_header(value);
      next_.text.resize(length());
      message_ = next_;
      ++read_;
      step_ = Step::kIdle;
      return;
  }
  step_ = next_.text.size() < length() ? Step::kText : Step::kHeaderAgain;
}

}  // namespace armature::cosim
