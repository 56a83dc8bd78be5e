// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for the process that pellucid-read-vdb is, and no other.

#include <openvdb/io/DelayedLoadMetadata.h>
#include <openvdb/openvdb.h>

#include <filesystem>
#include <memory>

#include "core/error.h"
#include "readers/vdb/vdb_precheck.h"

namespace pellucid::readers {

/// Opens an OpenVDB file once precheck_vdb() has checked its claims. Throws InputError when it is
/// missing or claims too much, openvdb::Exception when OpenVDB cannot read it.
inline std::unique_ptr<openvdb::io::File> open_vdb(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": no such file");
  precheck_vdb(path);
  openvdb::initialize();
  openvdb::io::DelayedLoadMetadata::unregisterType();  // it trusts a count of its own, unused here
  auto file = std::make_unique<openvdb::io::File>(path.string());
  file->open(false);  // not delayed: what cannot be read is known now
  return file;
}

}  // namespace pellucid::readers
