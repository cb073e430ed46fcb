// The assignment of the fields of a block to the members of a value, one list of pairs for both directions.
#pragma once

namespace armature::mailbox {

// Specialised for each type that goes through the mailbox, with
//   Block      the type of the block,
//   kKind      of commands and events: the number of their type, part of the layout and never reused,
//   transfer() assigns all fields. `copy` is Encode or Decode of wire.hpp. With Encode the value is const, with Decode
//              the block.
template <class Value>
struct FieldsOf;

}  // namespace armature::mailbox
