// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>
#include <system_error>

#include "core/error.h"
#include "core/files/descriptor.h"
#include "core/files/files_read.h"
#include "core/files/pages.h"
#include "core/files/process_and_number.h"
#include "core/files/write_failure.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

void write_all(const Descriptor& file, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.fd, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_writing(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Temporaries of one target have this around the numbers of their process and within it.
struct TemporaryName {
  explicit TemporaryName(const fs::path& target)
      : prefix(fmt::format(".{}.", target.stem().string())), suffix(target.extension().string()) {}

  fs::path mine() const { return fmt::format("{}{}{}", prefix, process_and_number(), suffix); }
  bool fits(const std::string& name) const {
    if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) ||
        !name.ends_with(suffix))
      return false;
    const auto middle =
        std::string_view(name).substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    return middle.find_first_not_of("0123456789-") == std::string_view::npos;
  }

  std::string prefix, suffix;
};

/// Who writes a temporary holds a lock on it for as long as he lives, on other machines too.
void remove_abandoned_files(const fs::path& target) {
  const TemporaryName names(target);
  std::error_code code;
  for (fs::directory_iterator at(folder_of(target), code), end; !code && at != end;
       at.increment(code)) {
    if (!names.fits(at->path().filename().string())) continue;
    const Descriptor file(
        ::open(at->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (file.fd < 0 || ::flock(file.fd, LOCK_EX | LOCK_NB) != 0) continue;
    std::error_code ignored;
    fs::remove(at->path(), ignored);
  }
}

/// Devices and pipes take what is written into them; theirs is made where temporaries belong.
fs::path place_of_temporary(const fs::path& target, bool is_regular) {
  std::error_code code;
  return (is_regular ? target.parent_path() : fs::temp_directory_path(code)) /
         TemporaryName(target).mine();
}

bool is_at(const fs::path& path, int file) {
  struct stat there {
  }, open{};
  return ::fstat(file, &open) == 0 && ::lstat(path.c_str(), &there) == 0 &&
         open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

/// Makes the file, which nobody else has, and locks it: the descriptor, or -1. Before it is locked
/// another writer of the target may take it for an abandoned one.
int make_temporary(const fs::path& path) {
  for (;;) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) return -1;
    while (::flock(file, LOCK_EX) != 0 && errno == EINTR)
      continue;  // whoever has it removes the file
    if (is_at(path, file)) return file;
    ::close(file);
  }
}

/// Of this process, that a path such as /dev/stdout or /dev/fd/3 leads to; -1 for any other path.
int descriptor_of(const fs::path& path) {
  std::error_code code;
  const fs::path all = fs::canonical("/proc/self/fd", code);
  if (code || fs::canonical(folder_of(path), code) != all || code) return -1;
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number : -1;
}

/// A descriptor is written on where it stands: opened anew, a file would be written from its begin.
Descriptor open_device(const fs::path& path) {
  const int own = descriptor_of(path);
  return Descriptor(own >= 0 ? ::fcntl(own, F_DUPFD_CLOEXEC, 0)
                             : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
}

void copy_into(const fs::path& from, const fs::path& to, const fs::path& path) {
  const Descriptor source(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  const Descriptor target = open_device(to);
  if (source.fd < 0 || target.fd < 0) fail_writing(path, errno);
  char block[1 << 16];
  for (ssize_t got; (got = ::read(source.fd, block, sizeof block)) != 0;) {
    if (got < 0 && errno != EINTR) fail_writing(path, errno);
    if (got > 0) write_all(target, {block, std::size_t(got)}, path);
  }
}

[[noreturn]] void cannot_read(const fs::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: cannot read: {}", path.string(), why));
}

}  // namespace

fs::path behind_links(const fs::path& path) {
  std::error_code code;
  fs::path target = path;
  for (int links = 0; links < 40 && fs::is_symlink(target, code); ++links) {
    if (descriptor_of(target) >= 0) break;  // its link may name no file: "pipe:[1234]"
    const fs::path next = fs::read_symlink(target, code);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), target_(behind_links(path_)) {
  ProtectedInputs::refuse(path_);
  std::error_code code;
  const fs::file_status status = fs::status(target_, code);
  if (code == std::errc::too_many_symbolic_link_levels) fail_writing(path_, ELOOP);
  if (fs::is_directory(status)) fail_writing(path_, EISDIR);
  is_regular_ = descriptor_of(target_) < 0 && (!fs::exists(status) || fs::is_regular_file(status));
  if (is_regular_) remove_abandoned_files(target_);
  do {
    temporary_ = place_of_temporary(target_, is_regular_);
    lock_ = make_temporary(temporary_);
  } while (lock_ < 0 && errno == EEXIST);
  if (lock_ < 0) fail_writing(path_, errno);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

void OutputFile::commit() {
  if (!is_regular_) return copy_into(temporary_, target_, path_);
  {
    const Descriptor file(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.fd < 0 || ::fsync(file.fd) != 0) fail_writing(path_, errno);
  }
  std::error_code code;
  fs::rename(temporary_, target_, code);
  if (code) fail_writing(path_, code.value());
  temporary_.clear();
}

void write_text(const fs::path& path, std::string_view text) {
  OutputFile out(path);
  {
    const Descriptor file(::open(out.temporary().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (file.fd < 0) fail_writing(path, errno);
    write_all(file, text, path);
  }
  out.commit();
}

void require_file(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) cannot_read(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) cannot_read(path, std::strerror(EISDIR));
  if (!S_ISREG(status.st_mode)) cannot_read(path, "a pipe or a device; accepted: a file");
  if (::access(path.c_str(), R_OK) != 0) cannot_read(path, std::strerror(errno));
  const double memory = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE));
  if (double(status.st_size) > memory)
    cannot_read(path, fmt::format("its {:.3g} bytes are more than this machine's memory holds",
                                  double(status.st_size)));
}

std::string read_text(const fs::path& path) {
  require_file(path);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.fd < 0) cannot_read(path, std::strerror(errno));
  std::string text;
  struct stat about {};
  if (::fstat(file.fd, &about) == 0 && S_ISREG(about.st_mode))
    reserve_in_huge_pages(text, std::size_t(about.st_size));
  char block[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.fd, block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) cannot_read(path, std::strerror(errno));
    if (got == 0) break;
    text.append(block, static_cast<std::size_t>(got));
  }
  note_read(path);
  return text;
}

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

}  // namespace pellucid
