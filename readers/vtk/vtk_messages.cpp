// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <algorithm>

namespace pellucid::readers {
namespace {

std::mutex& output_mutex() {
  static std::mutex mutex;
  return mutex;
}

class Capture final : public vtkOutputWindow {
 public:
  static Capture* New();

  void DisplayText(const char* text) override {
    const std::lock_guard lock(mutex_);  // readers may decompress on several threads
    if (first.empty() && text && !is_harmless(text)) first = text;
  }
  std::string first;
  std::span<const std::string_view> harmless;

 private:
  bool is_harmless(std::string_view text) const {
    return std::ranges::any_of(harmless,
                               [&](std::string_view word) { return text.find(word) != text.npos; });
  }
  std::mutex mutex_;
};

vtkStandardNewMacro(Capture);

}  // namespace

VtkMessages::VtkMessages(std::span<const std::string_view> harmless)
    : lock_(output_mutex()),
      before_(vtkOutputWindow::GetInstance()),
      verbosity_before_(vtkLogger::GetCurrentVerbosityCutoff()) {
  Capture* const capture = Capture::New();
  capture->harmless = harmless;
  capture_.TakeReference(capture);
  vtkOutputWindow::SetInstance(capture_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // the second way to stderr
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(before_);
  vtkLogger::SetStderrVerbosity(verbosity_before_);
}

std::string VtkMessages::first_line() const {
  std::string text = static_cast<const Capture*>(capture_.Get())->first;
  // "ERROR: In FILE, line N\nvtkClass (0x…): what happened\n\n"
  if (const std::size_t place = text.find("): "); place != std::string::npos)
    text.erase(0, place + 3);
  // "Generic Warning: In FILE, line N\nwhat happened\n": of functions that belong to no object.
  if (const std::size_t end = text.find('\n'); text.starts_with("Generic Warning: "))
    text.erase(0, end == std::string::npos ? 0 : end + 1);
  text.erase(std::find(text.begin(), text.end(), '\n'), text.end());
  return text;
}

}  // namespace pellucid::readers
