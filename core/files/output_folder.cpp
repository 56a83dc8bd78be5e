// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <set>
#include <string>
#include <system_error>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/process_and_number.h"
#include "core/files/write_failure.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

fs::path without_last_slash(const fs::path& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

std::string prefix_of(const fs::path& target) {
  return fmt::format(".{}.folder-", target.filename().string());
}

int open_folder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
}

/// Makes the folder, which nobody else has, and locks it: the descriptor, or -1. Before it is
/// locked another writer of the target may take it for an abandoned one, and removes it.
int make_temporary(const fs::path& folder, const fs::path& path) {
  for (;;) {
    std::error_code code;
    if (!fs::create_directory(folder, code) && code) fail_writing(path, code.value());
    const int fd = open_folder(folder);
    if (fd < 0 && errno == ENOENT) continue;
    while (fd >= 0 && ::flock(fd, LOCK_EX) != 0 && errno == EINTR) continue;
    struct stat held {};
    if (fd < 0 || (::fstat(fd, &held) == 0 && held.st_nlink > 0)) return fd;
    ::close(fd);
  }
}

/// Who writes a temporary holds a lock on it for as long as he lives.
void remove_abandoned_folders(const fs::path& target) {
  std::error_code code;
  for (fs::directory_iterator at(target.parent_path(), code), end; !code && at != end;
       at.increment(code)) {
    if (!at->path().filename().string().starts_with(prefix_of(target))) continue;
    const int fd = open_folder(at->path());
    std::error_code ignored;
    if (fd >= 0 && ::flock(fd, LOCK_EX | LOCK_NB) == 0) fs::remove_all(at->path(), ignored);
    if (fd >= 0) ::close(fd);
  }
}

/// All files below the folder, by their paths from it; links are files.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_symlink() || !entry.is_directory())
      files.insert(entry.path().lexically_relative(folder).generic_string());
  return files;
}

std::set<std::string> listed_in(const fs::path& folder) {
  std::set<std::string> names{folder_list};
  std::ifstream list(folder / folder_list);
  for (std::string name; std::getline(list, name);) names.insert(name);
  return names;
}

void write_list(const fs::path& folder) {
  const std::set<std::string> files = files_in(folder);
  std::ofstream list(folder / folder_list);
  for (const std::string& name : files) list << name << '\n';
  if (!list.flush()) fail_writing(folder / folder_list, ENOSPC);
}

void check_place(const fs::path& path, const fs::path& target) {
  std::error_code code;
  const fs::file_status status = fs::status(target, code);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) fail_writing(path, ENOTDIR);
  const std::set<std::string> files = files_in(target), listed = listed_in(target);
  for (const std::string& file : files) {
    if (!listed.contains(file))
      throw InputError(
          fmt::format("{}: holds other files: '{}'; accepted: a new folder, an empty one, or one "
                      "to be replaced, which holds what a run before has written and no more",
                      path.string(), file));
    ProtectedInputs::refuse(target / file);
  }
}

/// The message about files below `hidden`, as one about files below `given`.
std::string renamed(std::string message, const fs::path& hidden, const fs::path& given) {
  const std::string from = hidden.string(), to = (given / "").parent_path().string();
  for (std::size_t at = 0; (at = message.find(from, at)) != message.npos; at += to.size())
    message.replace(at, from.size(), to);
  return message;
}

}  // namespace

OutputFolder::OutputFolder(fs::path path)
    : path_(std::move(path)), target_(without_last_slash(path_)) {
  std::error_code code;
  if (const fs::path behind = fs::canonical(target_, code); !code) target_ = behind;
  check_place(path_, target_);
  remove_abandoned_folders(target_);
  temporary_ = target_.parent_path() / (prefix_of(target_) + process_and_number());
  lock_ = make_temporary(temporary_, path_);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

void OutputFolder::fill(const std::function<void(const fs::path& to)>& write) const {
  try {
    write(temporary_);
  } catch (const InputError& error) {
    throw InputError(renamed(error.what(), temporary_, path_));
  } catch (const WorkError& error) {
    throw WorkError(renamed(error.what(), temporary_, path_));
  } catch (const fs::filesystem_error& error) {  // a folder within could not be made
    fail_writing(path_, error.code().value());
  }
}

void OutputFolder::commit() {
  check_place(path_, target_);  // what has come, or was read, since
  write_list(temporary_);
  // What was there is swapped for the new one in one step, and goes away under its name.
  if (fs::exists(target_) &&
      ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
  } else {
    std::error_code code;
    fs::remove_all(target_, code);  // a file system that cannot swap
    fs::rename(temporary_, target_, code);
    if (code) fail_writing(path_, code.value());
  }
  temporary_.clear();
}

}  // namespace pellucid
