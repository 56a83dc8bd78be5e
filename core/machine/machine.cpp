// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "core/machine/build_info.h"

namespace pellucid {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

double memory_gib() {
  return double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE)) / (1 << 30);
}

}  // namespace

std::map<std::string, std::string> machine_facts() {
  utsname system{};
  ::uname(&system);
  return {{"cpu", cpu_model()},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"memory_gib", fmt::format("{:.1f}", memory_gib())},
          {"kernel", fmt::format("{} {}", system.sysname, system.release)},
          {"compiler", build_compiler},
          {"version", build_version},
          {"build", build_id()},
          {"commit", build_commit}};
}

}  // namespace pellucid
