#include "cosim/iss/elf_image.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace armature::cosim::iss {
namespace {

template <class T>
T record_at(std::span<const std::uint8_t> file, std::size_t offset) {
  if (offset > file.size() || file.size() - offset < sizeof(T)) throw std::runtime_error{"the ARM program is cut off"};
  T record;
  std::memcpy(&record, file.data() + offset, sizeof record);
  return record;
}

std::span<const std::uint8_t> part(std::span<const std::uint8_t> file, std::size_t offset, std::size_t size) {
  if (offset > file.size() || file.size() - offset < size) throw std::runtime_error{"the ARM program is cut off"};
  return file.subspan(offset, size);
}

}  // namespace

ElfImage::ElfImage(std::span<const std::uint8_t> file) {
  const auto header = record_at<Elf32_Ehdr>(file, 0);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS32 ||
      header.e_ident[EI_DATA] != ELFDATA2LSB || header.e_machine != EM_ARM) {
    throw std::runtime_error{"the ARM program is not a 32-bit little-endian ELF file for ARM"};
  }
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const auto program = record_at<Elf32_Phdr>(file, header.e_phoff + i * sizeof(Elf32_Phdr));
    if (program.p_type != PT_LOAD || program.p_filesz == 0) continue;
    segments_.push_back({program.p_paddr, part(file, program.p_offset, program.p_filesz)});
  }
  for (std::size_t i = 0; i < header.e_shnum; ++i) {
    const auto section = record_at<Elf32_Shdr>(file, header.e_shoff + i * sizeof(Elf32_Shdr));
    if (section.sh_type != SHT_SYMTAB) continue;
    const auto names = record_at<Elf32_Shdr>(file, header.e_shoff + section.sh_link * sizeof(Elf32_Shdr));
    const auto text = part(file, names.sh_offset, names.sh_size);
    for (std::size_t at = 0; at + sizeof(Elf32_Sym) <= section.sh_size; at += sizeof(Elf32_Sym)) {
      const auto symbol = record_at<Elf32_Sym>(file, section.sh_offset + at);
      if (symbol.st_name >= text.size() || ELF32_ST_BIND(symbol.st_info) != STB_GLOBAL) continue;
      const auto name = text.subspan(symbol.st_name);
      symbols_.emplace(std::string{name.begin(), std::ranges::find(name, 0)}, symbol.st_value);
    }
  }
}

std::uint32_t ElfImage::symbol(std::string_view name) const {
  const auto found = symbols_.find(name);
  if (found == symbols_.end()) throw std::runtime_error{fmt::format("the ARM program has no symbol {}", name)};
  return found->second;
}

}  // namespace armature::cosim::iss
