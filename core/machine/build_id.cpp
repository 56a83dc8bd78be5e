// SPDX-License-Identifier: GPL-3.0-or-later
#include <elf.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <link.h>

#include <cstdint>
#include <cstring>
#include <span>

#include "core/machine/build_info.h"

namespace pellucid {
namespace {

using Bytes = std::span<const unsigned char>;

/// Notes lie one after another: a header, then name and description, each padded to four bytes.
std::string id_in(Bytes notes) {
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes.data(), sizeof note);
    const std::size_t name = sizeof note, description = name + padded(note.n_namesz);
    const std::size_t end = description + padded(note.n_descsz);
    if (end > notes.size()) break;
    const bool gnu = note.n_namesz == 4 && std::memcmp(&notes[name], "GNU", 4) == 0;
    if (gnu && note.n_type == NT_GNU_BUILD_ID)
      return fmt::format("{:02x}", fmt::join(notes.subspan(description, note.n_descsz), ""));
    notes = notes.subspan(end);
  }
  return {};
}

/// Is this code part of the loaded file?
bool holds_this_code(const dl_phdr_info& file) {
  const auto here = reinterpret_cast<std::uintptr_t>(&build_id);
  for (int i = 0; i < file.dlpi_phnum; ++i) {
    const std::uintptr_t begin = file.dlpi_addr + file.dlpi_phdr[i].p_vaddr;
    const bool inside = here >= begin && here - begin < file.dlpi_phdr[i].p_memsz;
    if (file.dlpi_phdr[i].p_type == PT_LOAD && inside) return true;
  }
  return false;
}

int visit_file(dl_phdr_info* program, std::size_t, void* result) {
  if (!holds_this_code(*program)) return 0;
  for (int i = 0; i < program->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = program->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const auto* begin = reinterpret_cast<const unsigned char*>(program->dlpi_addr + part.p_vaddr);
    std::string id = id_in({begin, part.p_memsz});
    if (!id.empty()) *static_cast<std::string*>(result) = std::move(id);
  }
  return 1;  // no other file is asked
}

}  // namespace

std::string build_id() {
  std::string id = "unknown";
  ::dl_iterate_phdr(visit_file, &id);
  return id;
}

}  // namespace pellucid
