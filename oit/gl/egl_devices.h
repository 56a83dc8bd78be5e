// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oit/gl/gl_platform.h"

namespace pellucid::oit {

/// An EglDevice is one that EGL can render on, as the driver tells it.
struct EglDevice {
  std::string name;  // its renderer or its device file
  bool software;     // computed by the processor: Mesa's llvmpipe
};

/// Returns the devices in EGL's order, which is their number in "egl:N"; none where EGL cannot be
/// loaded or does not enumerate them.
std::vector<EglDevice> egl_devices();

/// What --gl takes: "osmesa", "egl" (the first device that is not software), "egl:software", and
/// "egl:N" by its number. For messages.
constexpr std::string_view accepted_gl = "osmesa|egl|egl:N|egl:software (see 'list gl')";

/// Returns whether the text is of this form; that there is such a device it does not say.
bool is_gl_kind(std::string_view kind);

/// Returns which of EGL's devices is meant by "egl", "egl:software" or "egl:N"; none where EGL has
/// not enumerated any, so that its own choice is the only one. Throws WorkError where none is
/// meant.
std::optional<std::size_t> choose_device(std::span<const EglDevice> devices, std::string_view kind);

/// Makes a 4.5 core context of EGL without a surface, on the device that choose_device() finds.
/// Throws WorkError when its library cannot be loaded or offers no such device or context.
std::unique_ptr<GlPlatform> make_egl_platform(std::string_view kind);

/// Returns whether OpenGL's renderer of this name computes on the processor.
bool is_software_renderer(std::string_view renderer);

}  // namespace pellucid::oit
