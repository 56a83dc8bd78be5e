// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/archive_writer.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>

#include <cstdlib>

#include "core/error.h"

namespace pellucid::compare {
namespace {

struct FreeEntry {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

/// While a Utf8Names of a name in UTF-8 lives, the C library takes this thread's texts for that.
/// libarchive says in an archive what its names are by the locale, which is "C" in this program: a
/// .zip would say nothing, so that an é is unpacked as two other characters, and a .tar would call
/// the name binary, of which tar warns.
class Utf8Names {
 public:
  explicit Utf8Names(const std::string& name)
      : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (!utf8_) return;
    before_ = uselocale(utf8_);
    if (std::mbstowcs(nullptr, name.c_str(), 0) == std::size_t(-1)) uselocale(before_);
  }
  ~Utf8Names() {
    if (!utf8_) return;
    uselocale(before_);
    freelocale(utf8_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;

 private:
  locale_t utf8_, before_ = nullptr;
};

void set_kind(archive* writer, ArchiveKind kind) {
  if (kind == ArchiveKind::zip) {
    archive_write_set_format_zip(writer);
    return;
  }
  archive_write_set_format_pax_restricted(writer);
  archive_write_add_filter_gzip(writer);
  archive_write_set_filter_option(writer, "gzip", "timestamp", nullptr);
}

}  // namespace

void ArchiveWriter::Free::operator()(archive* writer) const { archive_write_free(writer); }

ArchiveWriter::ArchiveWriter(const std::filesystem::path& to, ArchiveKind kind)
    : to_(to), file_(to), writer_(archive_write_new()) {
  set_kind(writer_.get(), kind);
  check(archive_write_open_filename(writer_.get(), file_.temporary().c_str()));
}

/// libarchive says what went wrong by its result, and by a text.
void ArchiveWriter::check(int result) const {
  if (result >= ARCHIVE_WARN) return;
  throw WorkError(
      fmt::format("{}: cannot write: {}", to_.string(), archive_error_string(writer_.get())));
}

void ArchiveWriter::begin(const std::string& path, std::uint64_t size, bool executable) {
  const std::unique_ptr<archive_entry, FreeEntry> entry(archive_entry_new());
  archive_entry_set_pathname(entry.get(), path.c_str());
  archive_entry_set_size(entry.get(), la_int64_t(size));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), executable ? 0755 : 0644);
  archive_entry_set_mtime(entry.get(), 0, 0);
  const Utf8Names names(path);
  check(archive_write_header(writer_.get(), entry.get()));
}

void ArchiveWriter::write(std::span<const char> bytes) {
  if (archive_write_data(writer_.get(), bytes.data(), bytes.size()) < 0) check(ARCHIVE_FATAL);
}

void ArchiveWriter::commit() {
  check(archive_write_close(writer_.get()));
  file_.commit();
}

}  // namespace pellucid::compare
