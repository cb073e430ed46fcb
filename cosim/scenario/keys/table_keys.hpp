// Compares the entries of a table with its keys in a file: which keys exist, and which ones exclude each other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim {

// A key may have several entries whose conditions exclude each other.
class TableKeys {
 public:
  // All must outlive this.
  TableKeys(TableReader& table, std::vector<const KeyInfo*> entries, const KeyContext& context);

  // Whether the conditions of the entry hold in the file.
  [[nodiscard]] bool exists(const KeyInfo& entry) const;
  // The rule and the need, with the parts that depend on the robot and on the file.
  [[nodiscard]] Rule rule(const KeyInfo& entry) const;
  [[nodiscard]] Need need(const KeyInfo& entry) const;

  // Reports keys that do not exist here, keys without what they need, and keys that exclude each other.
  void report();

 private:
  enum class Holds { kNo, kYes, kUnknown };  // unknown: the other key is missing or wrong, which is reported
  [[nodiscard]] Holds holds(const Condition& condition) const;
  [[nodiscard]] const KeyInfo* entry_of(std::string_view key) const;
  void report_absence_of(const KeyInfo& entry);
  void report_beside(const KeyInfo& entry);

  TableReader* table_;
  std::vector<const KeyInfo*> entries_;
  const KeyContext* context_;
};

}  // namespace armature::cosim
