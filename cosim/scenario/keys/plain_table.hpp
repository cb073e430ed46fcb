// The entries of a table without the type of its struct, which KeyTable (key_table.hpp) adds, and reading with them.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/keys/plain_key.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim {

// A table, or each table of an array, within another table.
struct PlainSubTable {
  TableInfo info;
  std::size_t place = 0;                      // of the member, in bytes from the begin of the struct
  void* (*emplaced)(void* member) = nullptr;  // the struct, or the list of structs
  void* (*added)(void* list) = nullptr;       // a new struct at the end of the list; nullptr: there is no list
  const void* keys = nullptr;                 // the KeyTable of the struct
  void (*read)(const void* keys, TableReader&, const KeyContext&, void* spec) = nullptr;
};

// A check of several keys of a table.
struct PlainTableCheck {
  std::vector<std::string_view> keys;  // the check is called if each of these is valid by itself
  std::function<void(TableReader&, const KeyContext&, void* spec)> check;
};

// Reads the keys. Returns those that are missing or wrong.
std::vector<std::string_view> read_plain_keys(const std::vector<PlainKey>& keys, TableReader& table,
                                              const KeyContext& context, void* spec);
// Reads the arrays with an element for each axis again, but those of `bad`, now that the context has a robot.
void count_plain_keys(const std::vector<PlainKey>& keys, const std::vector<std::string_view>& bad, TableReader& table,
                      const KeyContext& context, void* spec);
void read_plain_tables(const std::vector<PlainSubTable>& tables, TableReader& table, const KeyContext& context,
                       void* spec);
// Calls the checks that have none of the keys `bad`.
void check_plain_table(const std::vector<PlainTableCheck>& checks, const std::vector<std::string_view>& bad,
                       TableReader& table, const KeyContext& context, void* spec);

[[nodiscard]] TableInfo plain_table_info(std::string_view text, const std::vector<PlainKey>& keys,
                                         const std::vector<PlainSubTable>& tables);

}  // namespace armature::cosim
