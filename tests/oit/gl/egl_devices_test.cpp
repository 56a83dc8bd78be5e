// SPDX-License-Identifier: GPL-3.0-or-later
// Which of EGL's devices is meant, and that software is never taken for a graphics card.
#include "oit/gl/egl_devices.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "oit/gl/gl_context.h"

namespace pellucid::oit {
namespace {

using ::testing::HasSubstr;

const std::vector<EglDevice> machine = {{"llvmpipe", true}, {"card A", false}, {"card B", false}};

std::string error_of(std::span<const EglDevice> devices, std::string_view kind) {
  try {
    choose_device(devices, kind);
  } catch (const WorkError& error) {
    return error.what();
  }
  return "no error";
}

TEST(UnitEglDevices, EglIsTheFirstGraphicsCard) {
  EXPECT_EQ(choose_device(machine, "egl"), 1u);
  EXPECT_EQ(choose_device(machine, "egl:software"), 0u);
  EXPECT_EQ(choose_device(machine, "egl:0"), 0u);
  EXPECT_EQ(choose_device(machine, "egl:2"), 2u);
}

TEST(UnitEglDevices, WhatIsNotThereIsSaid) {
  const std::vector<EglDevice> software = {machine[0]}, card = {machine[1]};
  EXPECT_THAT(error_of(software, "egl"), HasSubstr("all devices compute in software"));
  EXPECT_THAT(error_of(card, "egl:software"), HasSubstr("no device computes in software"));
  EXPECT_THAT(error_of(machine, "egl:3"), HasSubstr("there are 3 devices"));
}

// Where EGL does not enumerate, its own choice is the only one, and a number means nothing.
TEST(UnitEglDevices, WithoutAListEglChooses) {
  EXPECT_EQ(choose_device({}, "egl"), std::nullopt);
  EXPECT_EQ(choose_device({}, "egl:software"), std::nullopt);
  EXPECT_THAT(error_of({}, "egl:0"), HasSubstr("there are 0 devices"));
}

TEST(UnitEglDevices, TheFormsAreKnown) {
  for (const char* kind : {"osmesa", "egl", "egl:software", "egl:0", "egl:12"})
    EXPECT_TRUE(is_gl_kind(kind)) << kind;
  for (const char* kind :
       {"", "glx", "egl:", "egl:x", "egl:-1", "egl:1x", "EGL", "egl:99999999999999999999"})
    EXPECT_FALSE(is_gl_kind(kind)) << kind;
}

TEST(UnitEglDevices, SoftwareIsKnownByItsRenderer) {
  EXPECT_TRUE(is_software_renderer("llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5"));
  EXPECT_FALSE(is_software_renderer("NVIDIA H200/PCIe/SSE2, OpenGL 4.5"));
  EXPECT_FALSE(is_software_renderer("AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6)"));
}

// Of this machine, whatever it has: the context that `egl` makes is no software's, and each device
// that EGL lists is what its row says.
TEST(AgreementEglDevices, ContextsAreWhatTheirRowsSay) {
  try {
    EXPECT_FALSE(is_software_renderer(GlContext("egl").driver()));
  } catch (const WorkError&) {  // no graphics card
  }
  const std::vector<EglDevice> devices = egl_devices();
  for (std::size_t i = 0; i < devices.size(); ++i) {
    std::string driver;
    try {
      driver = GlContext("egl:" + std::to_string(i)).driver();
    } catch (const WorkError&) {  // a device without OpenGL 4.5
      continue;
    }
    EXPECT_EQ(is_software_renderer(driver), devices[i].software) << driver;
  }
}

}  // namespace
}  // namespace pellucid::oit
