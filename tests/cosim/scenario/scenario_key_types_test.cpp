// Entries of keys belong to one struct, and reach members at any depth of it.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "cosim/scenario/keys/key_table.hpp"
#include "cosim/scenario/tables/kind_keys.hpp"
#include "cosim/scenario/toml/toml_document.hpp"

namespace armature::cosim {
namespace {

struct Inner {
  std::string name{"none"};
  std::optional<std::int64_t> count{};
};
struct Round {
  double radius = 1;
};
struct Square {
  std::array<double, 2> ignored{};
  double radius = 2;
};
struct RowSpec {
  bool on = false;
};
struct OuterSpec {
  double first = 7;
  Inner inner{};
  std::variant<Round, Square> kind{};
  std::vector<RowSpec> rows{};
  std::optional<RowSpec> maybe{};
};
struct OtherSpec {
  double first = 0;
  std::vector<Inner> rows{};
};

// Entries of another struct, or of another type, do not compile.
template <class List, class Entry>
concept Takes = requires(List& list, Entry entry) {
  list.push_back(entry);
};
static_assert(Takes<Keys<OuterSpec>, Key<OuterSpec>>);
static_assert(!Takes<Keys<OuterSpec>, Key<OtherSpec>>);
static_assert(!Takes<Keys<OuterSpec>, PlainKey>);
static_assert(!std::is_constructible_v<Keys<OuterSpec>, Keys<OtherSpec>>);

using CheckOfOuter = std::string (*)(const OuterSpec&, const KeyContext&);
using CheckOfOther = std::string (*)(OtherSpec&, const KeyContext&);
template <class Entry, class Check>
concept HasCheck = requires(Entry entry, Check check) {
  std::move(entry).checked(check);
};
static_assert(HasCheck<Key<OuterSpec>, CheckOfOuter>);
static_assert(!HasCheck<Key<OuterSpec>, CheckOfOther>);

template <class Member, class Rows>
concept IsList = requires(Member OuterSpec::*member, const KeyTable<Rows>& keys) {
  tables("rows", member, keys);
};
static_assert(IsList<std::vector<RowSpec>, RowSpec>);
static_assert(!IsList<std::vector<RowSpec>, Inner>);
static_assert(!IsList<std::optional<RowSpec>, RowSpec>);

template <class Member, class Table>
concept IsTable = requires(Member OuterSpec::*member, const KeyTable<Table>& keys) {
  table("maybe", member, keys);
};
static_assert(IsTable<std::optional<RowSpec>, RowSpec>);
static_assert(!IsTable<std::optional<RowSpec>, Inner>);
static_assert(!IsTable<std::vector<RowSpec>, RowSpec>);

template <class Kind>
struct ShapeEntry {
  std::string_view name;
  std::string_view text;
  Keys<Kind> keys;
};

const KeyTable<RowSpec>& row_keys() {
  static const KeyTable<RowSpec> kTable{.text = {}, .keys = {key("on", &RowSpec::on, anything(), "On.")}};
  return kTable;
}

const KeyTable<OuterSpec>& outer_keys() {
  static const KeyTable<OuterSpec> kTable = [] {
    constexpr auto kEntryOf = []<class Kind>(std::type_identity<Kind>) {
      return ShapeEntry<Kind>{
          .name = std::is_same_v<Kind, Round> ? "round" : "square",
          .text = "a shape",
          .keys = {key("radius", &Kind::radius, above(0, 100), "Radius.").checked([](Kind& kind, const KeyContext&) {
            kind.radius *= 2;
            return kind.radius > 100 ? std::string{"too large"} : std::string{};
          })}};
    };
    KeyTable<OuterSpec> table{
        .text = {},
        .keys = {key("first", &OuterSpec::first, anything(), "First."),
                 part(&OuterSpec::inner,
                      key("count", &Inner::count, at_least(0), "Count.").checked([](Inner& inner, const KeyContext&) {
                        return *inner.count == 13 ? "not 13 for " + inner.name : std::string{};
                      })),
                 part(&OuterSpec::inner, key("name", &Inner::name, anything(), "Name.")),
                 kind_key<OuterSpec>("shape", "Shape.", kEntryOf)},
        .tables = {cosim::tables("rows", &OuterSpec::rows, row_keys(), 2),
                   cosim::table("maybe", &OuterSpec::maybe, row_keys())},
        .checks = {{{"first"}, [](TableReader& reader, const KeyContext&, OuterSpec& spec) {
                      if (spec.first > 50) reader.problem("first", "above 50");
                    }}}};
    add_kind_keys(table.keys, "shape", kEntryOf);
    return table;
  }();
  return kTable;
}

struct ReadFile {
  OuterSpec spec{};
  std::vector<Problem> problems{};
};

ReadFile read(const std::string& text) {
  ReadFile file;
  const ConfigValue root = parse_toml(text, "file");
  ProblemList problems{"file"};
  TableReader reader{root, "", problems};
  outer_keys().read(reader, {}, file.spec);
  reader.finish();
  problems.move_to(file.problems);
  return file;
}

TEST(KeyTypes, EachKeySetsItsOwnMember) {
  const ReadFile file =
      read("first = 3\nname = \"a\"\ncount = 4\nshape = \"square\"\nradius = 5\n[maybe]\non = true\n");
  EXPECT_TRUE(file.problems.empty());
  EXPECT_EQ(file.spec.first, 3);
  EXPECT_EQ(file.spec.inner.name, "a");
  EXPECT_EQ(file.spec.inner.count, 4);
  ASSERT_TRUE(std::holds_alternative<Square>(file.spec.kind));
  EXPECT_EQ(std::get<Square>(file.spec.kind).radius, 10);
  EXPECT_EQ(std::get<Square>(file.spec.kind).ignored, (std::array<double, 2>{}));
  ASSERT_TRUE(file.spec.maybe);
  EXPECT_TRUE(file.spec.maybe->on);
}

TEST(KeyTypes, AKeyOfSeveralKindsSetsAndChecksTheKindOfTheFile) {
  const ReadFile good = read("shape = \"round\"\nradius = 5\n");
  EXPECT_EQ(std::get<Round>(good.spec.kind).radius, 10);
  const ReadFile wrong = read("shape = \"round\"\nradius = 60\n");
  ASSERT_EQ(wrong.problems.size(), 1u);
  EXPECT_NE(wrong.problems.front().text().find("radius: too large"), std::string::npos)
      << wrong.problems.front().text();
  const TableInfo info = outer_keys().info();
  ASSERT_EQ(info.keys.size(), 5u);
  EXPECT_EQ(info.keys.back().conditions.front().values, (std::vector<std::string_view>{"round", "square"}));
}

TEST(KeyTypes, ACheckOfAPartGetsThePart) {
  const ReadFile file = read("name = \"b\"\ncount = 13\nshape = \"round\"\n");
  ASSERT_EQ(file.problems.size(), 1u);
  EXPECT_NE(file.problems.front().text().find("not 13 for b"), std::string::npos) << file.problems.front().text();
}

TEST(KeyTypes, ACheckOfATableNeedsItsKeysToBeGood) {
  EXPECT_EQ(read("first = 60\nshape = \"round\"\n").problems.size(), 1u);
  const ReadFile wrong = read("first = \"60\"\nshape = \"round\"\n");
  ASSERT_EQ(wrong.problems.size(), 1u);
  EXPECT_EQ(wrong.problems.front().text().find("above 50"), std::string::npos);
}

TEST(KeyTypes, EachTableOfAnArrayIsAnElement) {
  const ReadFile two = read("shape = \"round\"\n[[rows]]\non = true\n[[rows]]\n");
  EXPECT_TRUE(two.problems.empty());
  ASSERT_EQ(two.spec.rows.size(), 2u);
  EXPECT_TRUE(two.spec.rows[0].on);
  EXPECT_FALSE(two.spec.rows[1].on);
  EXPECT_EQ(read("shape = \"round\"\n[[rows]]\n[[rows]]\n[[rows]]\n").problems.size(), 1u);
}

TEST(KeyTypes, DefaultsAreThoseOfTheMembers) {
  const TableInfo info = outer_keys().info();
  EXPECT_EQ(info.keys[0].default_text, "7");
  EXPECT_EQ(info.keys[1].default_text, "");
  EXPECT_EQ(info.keys[2].default_text, "\"none\"");
}

TEST(KeyTypes, ValuesAreThoseOfTheStruct) {
  const Keys<Inner> keys{key("count", &Inner::count, anything(), "Count."),
                         key("name", &Inner::name, anything(), "Name.")};
  const std::vector<NamedValue> values = keys.values({.name = "c", .count = 9});
  ASSERT_EQ(values.size(), 2u);
  EXPECT_EQ(values[0].key, "count");
  EXPECT_EQ(values[0].value, KeyValue{std::int64_t{9}});
  EXPECT_EQ(values[1].value, KeyValue{std::string{"c"}});
}

}  // namespace
}  // namespace armature::cosim
