// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/files/output_folder.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t tar_block = 512;

/// What a ustar header's numbers are: octal digits and a NUL.
std::string octal(std::uint64_t value, std::size_t width) {
  return fmt::format("{:0{}o}", value, width - 1) + '\0';
}

void put(std::string& header, std::size_t at, std::string_view text) {
  std::memcpy(header.data() + at, text.data(), text.size());
}

/// POSIX.1-1988, ustar: name, mode, owner, size, time, sum of the header's bytes, kind.
std::string tar_header(std::string_view path, std::size_t size, char kind, bool executable) {
  std::string header(tar_block, '\0');
  put(header, 0, path.substr(0, 100));
  put(header, 100, octal(executable ? 0755 : 0644, 8));
  put(header, 108, octal(0, 8));
  put(header, 116, octal(0, 8));
  put(header, 124, octal(size, 12));
  put(header, 136, octal(0, 12));
  put(header, 148, "        ");
  header[156] = kind;
  put(header, 257,
      std::string_view("ustar\0"
                       "00",
                       8));
  unsigned sum = 0;
  for (const char c : header) sum += std::uint8_t(c);
  put(header, 148, octal(sum, 7) + ' ');
  return header;
}

std::string padded(std::string text) {
  text.resize((text.size() + tar_block - 1) / tar_block * tar_block, '\0');
  return text;
}

std::string tar_entry(const std::string& path, const std::string& content, bool executable) {
  std::string entry;
  if (path.size() > 100)
    entry = tar_header("././@LongLink", path.size() + 1, 'L', false) + padded(path + '\0');
  return entry + tar_header(path, content.size(), '0', executable) + padded(content);
}

/// A Deflater compresses what it is given; a negative `bits` leaves zlib's own frame out.
class Deflater {
 public:
  explicit Deflater(int bits) {
    if (deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, bits, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw WorkError("zlib cannot begin");
  }
  ~Deflater() { deflateEnd(&stream_); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  /// Appends what is ready of the compressed bytes; all of them after the last.
  void add(std::string_view bytes, bool last, std::string& out) {
    constexpr std::size_t most = std::size_t(1) << 30;  // zlib counts in 32 bits
    do {
      const std::string_view part = bytes.substr(0, most);
      bytes.remove_prefix(part.size());
      compress(part, last && bytes.empty(), out);
    } while (!bytes.empty());
  }

 private:
  void compress(std::string_view part, bool last, std::string& out) {
    char buffer[1 << 16];
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    stream_.avail_in = uInt(part.size());
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer);
      stream_.avail_out = sizeof(buffer);
      deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
      out.append(buffer, sizeof(buffer) - stream_.avail_out);
    } while (stream_.avail_out == 0);
  }

  z_stream stream_ = {};
};

std::string tar_gz(const std::string& name, const std::vector<PackedFile>& files) {
  constexpr int gzip_bits = 15 + 16;
  std::string out;
  Deflater deflater(gzip_bits);
  for (const PackedFile& file : files)
    deflater.add(tar_entry(name + '/' + file.path, file.content(), file.executable), false, out);
  deflater.add(std::string(2 * tar_block, '\0'), true, out);
  return out;
}

void put_number(std::string& to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += char(value >> (8 * i));
}

/// A ZipEntry is what both of an entry's headers say (PKWARE's APPNOTE 6.3.3, 4.3.7 and 4.3.12).
struct ZipEntry {
  std::string path;
  std::uint32_t sum = 0;
  std::size_t packed = 0, size = 0, at = 0;
  bool executable = false;

  /// From the version on to the lengths of name and extra field; the first day that DOS knows.
  std::string common() const {
    std::string text;
    put_number(text, 20, 2);
    put_number(text, 1 << 11, 2);  // names are UTF-8
    put_number(text, Z_DEFLATED, 2);
    put_number(text, 0, 2);
    put_number(text, (1 << 5) | 1, 2);
    put_number(text, sum, 4);
    put_number(text, packed, 4);
    put_number(text, size, 4);
    put_number(text, path.size(), 2);
    put_number(text, 0, 2);
    return text;
  }
  std::string local() const { return "PK\x03\x04" + common() + path; }
  std::string central() const {
    std::string text = "PK\x01\x02";
    put_number(text, 3 << 8 | 20, 2);  // made by Unix, whose modes follow
    text += common();
    put_number(text, 0, 6);
    put_number(text, std::uint64_t(executable ? 0100755 : 0100644) << 16, 4);
    put_number(text, at, 4);
    return text + path;
  }
};

void check_zip(std::size_t size, std::size_t files) {
  if (size > std::numeric_limits<std::uint32_t>::max() || files > 65535)
    throw InputError("pack: a .zip holds less than 4 GiB and 65536 files; accepted: .tar.gz");
}

std::string zip(const std::string& name, const std::vector<PackedFile>& files) {
  std::string out, directory;
  for (const PackedFile& file : files) {
    const std::string content = file.content();
    check_zip(content.size(), files.size());
    std::string packed;
    Deflater(-15).add(content, true, packed);
    ZipEntry entry{name + '/' + file.path, 0,          packed.size(),
                   content.size(),         out.size(), file.executable};
    entry.sum =
        std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()));
    out += entry.local() + packed;
    directory += entry.central();
    check_zip(out.size() + directory.size(), files.size());
  }
  std::string end = "PK\x05\x06";
  put_number(end, 0, 4);
  put_number(end, files.size(), 2);
  put_number(end, files.size(), 2);
  put_number(end, directory.size(), 4);
  put_number(end, out.size(), 4);
  put_number(end, 0, 2);
  return out + directory + end;
}

void write_folder(const fs::path& to, const std::vector<PackedFile>& files) {
  OutputFolder folder(to, "ro-crate-metadata.json");
  for (const PackedFile& file : files) {
    const fs::path path = folder.temporary() / file.path;
    fs::create_directories(path.parent_path());
    write_text(path, file.content());
    if (file.executable) fs::permissions(path, fs::perms(0755));
  }
  folder.commit();
}

bool ends(const fs::path& path, std::string_view ending) {
  return path.filename().string().ends_with(ending);
}

}  // namespace

std::string PackedFile::content() const { return source.empty() ? text : read_text(source); }

std::string package_name(const fs::path& to) {
  std::string name = fs::absolute(to / "").parent_path().filename().string();
  for (const std::string_view ending : {".tar.gz", ".tgz", ".zip"})
    if (name.ends_with(ending) && name.size() > ending.size())
      return name.substr(0, name.size() - ending.size());
  return name;
}

void write_package(const fs::path& to, const std::string& name,
                   const std::vector<PackedFile>& files) {
  if (ends(to, ".zip")) return write_text(to, zip(name, files));
  if (ends(to, ".tar.gz") || ends(to, ".tgz")) return write_text(to, tar_gz(name, files));
  write_folder(to, files);
}

}  // namespace pellucid::compare
