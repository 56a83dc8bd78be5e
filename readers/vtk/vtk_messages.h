// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <span>
#include <string>
#include <string_view>

namespace pellucid::readers {

/// While a VtkMessages lives, VTK's warnings and errors are kept in it instead of printed. VTK has
/// one output for the whole process, so these objects wait for each other.
class VtkMessages {
 public:
  /// Messages with one of the `harmless` words are passed over.
  explicit VtkMessages(std::span<const std::string_view> harmless = {});
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// Returns the first message, without VTK's file, line and object; empty when there was none.
  std::string first_line() const;

 private:
  std::unique_lock<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_before_;
  vtkSmartPointer<vtkOutputWindow> capture_;
};

}  // namespace pellucid::readers
