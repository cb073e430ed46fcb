#include "cosim/exports/npz_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include "cosim/exports/crc32.hpp"
#include "cosim/exports/little_endian.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

// The head of a .npy file of version 1.0. The data begins at a multiple of 64.
std::string npy_head(std::string_view type, std::size_t count) {
  constexpr std::size_t kAlignment = 64;
  constexpr std::size_t kFixed = 10;  // magic, version, length
  std::string words = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}", type, count);
  const std::size_t unpadded = kFixed + words.size() + 1;
  words.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
  words += '\n';
  std::string head{"\x93NUMPY\x01\x00", 8};
  append_number(head, static_cast<std::uint16_t>(words.size()));
  return head + words;
}

template <class Number>
std::string npy(std::string_view type, const std::vector<Number>& values) {
  std::string bytes = npy_head(type, values.size());
  bytes.reserve(bytes.size() + values.size() * sizeof(Number));
  for (const Number value : values) append_number(bytes, value);
  return bytes;
}

// What the head of a file and its entry in the directory have in common: version 2.0, no compression, the first moment
// that a ZIP file knows, so that equal runs give equal bytes.
std::string zip_fields(std::string_view bytes, std::size_t name_size) {
  constexpr std::uint16_t kVersion = 20, kStored = 0, kMidnight = 0, kFirstOf1980 = 0x21;
  std::string fields;
  for (const std::uint16_t value : {kVersion, std::uint16_t{0}, kStored, kMidnight, kFirstOf1980}) {
    append_number(fields, value);
  }
  append_number(fields, crc32(bytes));
  append_number(fields, static_cast<std::uint32_t>(bytes.size()));
  append_number(fields, static_cast<std::uint32_t>(bytes.size()));
  append_number(fields, static_cast<std::uint16_t>(name_size));
  append_number(fields, std::uint16_t{0});  // no more fields
  return fields;
}

}  // namespace

void NpzWriter::write(std::string_view name, const std::vector<std::int64_t>& values) {
  add_file(std::string{name} + ".npy", npy("<i8", values));
}

void NpzWriter::write(std::string_view name, const std::vector<double>& values) {
  add_file(std::string{name} + ".npy", npy("<f8", values));
}

// A character has four bytes, and shorter texts end with zeros.
void NpzWriter::write(std::string_view name, const std::vector<std::string>& values) {
  std::size_t longest = 1;
  for (const std::string& value : values) longest = std::max(longest, value.size());
  std::string bytes = npy_head(fmt::format("<U{}", longest), values.size());
  for (const std::string& value : values) {
    for (std::size_t i = 0; i < longest; ++i) {
      append_number(bytes, i < value.size() ? std::uint32_t{static_cast<unsigned char>(value[i])} : 0U);
    }
  }
  add_file(std::string{name} + ".npy", bytes);
}

void NpzWriter::add_file(const std::string& name, std::string_view bytes) {
  const std::string fields = zip_fields(bytes, name.size());
  std::string head{"PK\x03\x04", 4};
  head += fields + name;
  directory_.append("PK\x01\x02", 4);
  append_number(directory_, std::uint16_t{20});  // the version that wrote it
  directory_ += fields;
  for (int i = 0; i < 3; ++i) append_number(directory_, std::uint16_t{0});  // comment, disk, attributes
  append_number(directory_, std::uint32_t{0});
  append_number(directory_, static_cast<std::uint32_t>(written_));
  directory_ += name;
  ++files_;
  for (const std::string_view part : {std::string_view{head}, bytes}) {
    out_.write(part.data(), static_cast<std::streamsize>(part.size()));
    written_ += part.size();
  }
}

void NpzWriter::finish() {
  if (written_ + directory_.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError{"--npz", "the arrays have more than 4 GiB; record fewer rows with --set trace.every_ticks=20"};
  }
  std::string end = directory_ + std::string{"PK\x05\x06", 4};
  append_number(end, std::uint32_t{0});  // one disk
  for (int i = 0; i < 2; ++i) append_number(end, files_);
  append_number(end, static_cast<std::uint32_t>(directory_.size()));
  append_number(end, static_cast<std::uint32_t>(written_));
  append_number(end, std::uint16_t{0});  // no comment
  out_.write(end.data(), static_cast<std::streamsize>(end.size()));
}

}  // namespace armature::cosim
