#include "controller/mailbox/codec.hpp"

#include <cstring>
#include <variant>

#include "controller/mailbox/command_fields.hpp"
#include "controller/mailbox/event_fields.hpp"
#include "controller/mailbox/wire.hpp"

namespace armature::mailbox {
namespace {

template <class Block, class... Alternatives>
Block encode_any(const std::variant<Alternatives...>& variant) noexcept {
  Block block{};
  const auto put = [&block]<class Value>(const Value& value) {
    using Fields = FieldsOf<Value>;
    typename Fields::Block fields{};
    static_assert(sizeof(fields) <= sizeof(block.body));
    Fields::transfer(Encode{}, fields, value);
    block.kind = Fields::kKind;
    std::memcpy(block.body.data(), &fields, sizeof(fields));
  };
  // std::visit is not used: its tables of pointers would need an exception for a variant without a value.
  const auto put_if = [&]<class Value>(const Value* value) {
    if (value != nullptr) put(*value);
  };
  (put_if(std::get_if<Alternatives>(&variant)), ...);
  return block;
}

template <class Value, class Block, class Variant>
void decode_if(const Block& block, std::optional<Variant>& result) noexcept {
  using Fields = FieldsOf<Value>;
  if (block.kind != Fields::kKind) return;
  typename Fields::Block fields{};
  std::memcpy(&fields, block.body.data(), sizeof(fields));
  Value value{};
  Fields::transfer(Decode{}, fields, value);
  result.emplace(value);
}

template <class Block, class... Alternatives>
std::optional<std::variant<Alternatives...>> decode_any(const Block& block,
                                                        std::type_identity<std::variant<Alternatives...>>) noexcept {
  std::optional<std::variant<Alternatives...>> result;
  (decode_if<Alternatives>(block, result), ...);
  return result;
}

}  // namespace

CommandBlock encode(const Command& command) noexcept {
  return encode_any<CommandBlock>(command);
}

EventBlock encode(const Event& event) noexcept {
  return encode_any<EventBlock>(event);
}

std::optional<Command> decode(const CommandBlock& block) noexcept {
  return decode_any(block, std::type_identity<Command>{});
}

std::optional<Event> decode(const EventBlock& block) noexcept {
  return decode_any(block, std::type_identity<Event>{});
}

}  // namespace armature::mailbox
