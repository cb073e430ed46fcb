#include "cosim/scenario/keys/plain_key.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace armature::cosim {
namespace {

void* behind(void* begin, std::size_t distance) {
  return static_cast<std::byte*>(begin) + distance;
}

// Whether two keys differ only in their kinds.
bool is_same_key(const KeyInfo& a, const KeyInfo& b) {
  return a.name == b.name && a.text == b.text &&
         std::equal(a.conditions.begin() + 1, a.conditions.end(), b.conditions.begin() + 1, b.conditions.end());
}

}  // namespace

PlainKey::Found PlainKey::find(void* spec) const {
  for (const KeyTarget& target : targets) {
    void* begin = target.kind == nullptr ? spec : target.kind(spec);
    if (begin != nullptr) return {.target = &target, .begin = begin};
  }
  assert(false && "the key that names the kind was read");
  return {.target = nullptr, .begin = nullptr};
}

bool PlainKey::read(TableReader& table, const Rule& rule, Need need, void* spec) const {
  const auto [target, begin] = find(spec);
  return target->read(table, info.name, rule, need, behind(begin, target->place));
}

std::string PlainKey::check(void* spec, const KeyContext& context) const {
  const auto [target, begin] = find(spec);
  return target->check ? target->check(behind(begin, target->checked), context) : std::string{};
}

KeyValue PlainKey::value(const void* spec) const {
  const KeyTarget& target = targets.front();
  return target.value(static_cast<const std::byte*>(spec) + target.place);
}

void PlainKey::move_by(std::size_t distance) {
  for (KeyTarget& target : targets) {
    target.place += distance;
    target.checked += distance;
  }
}

std::vector<NamedValue> values_of(const std::vector<PlainKey>& keys, const void* spec) {
  std::vector<NamedValue> values;
  values.reserve(keys.size());
  for (const PlainKey& key : keys) values.push_back({.key = key.info.name, .value = key.value(spec)});
  return values;
}

void add_keys_of_kind(std::vector<PlainKey>& keys, const std::vector<PlainKey>& added, std::string_view kind_key,
                      std::string_view name, void* (*kind)(void* spec)) {
  for (PlainKey key : added) {
    key.info.conditions.insert(key.info.conditions.begin(), when(kind_key, {name}));
    for (KeyTarget& target : key.targets) target.kind = kind;
    const auto same = std::ranges::find_if(keys, [&](const PlainKey& other) {
      return !other.info.conditions.empty() && is_same_key(other.info, key.info);
    });
    if (same == keys.end()) {
      keys.push_back(std::move(key));
      continue;
    }
    assert(same->info.need == key.info.need && !same->targets.front().check == !key.targets.front().check);
    same->info.conditions.front().values.push_back(name);
    same->targets.push_back(std::move(key.targets.front()));
  }
}

}  // namespace armature::cosim
