// SPDX-License-Identifier: GPL-3.0-or-later
// Every fuzzing target over its corpus, by whatever compiler builds the tests: what was found once
// stays mended, and the files that a reader is meant to accept are accepted, so that fuzzing starts
// beyond the first check.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "core/files/output_file.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/bytes.h"

#define PELLUCID_TARGET(name) \
  extern "C" int fuzz_##name(const std::uint8_t* data, std::size_t size);
PELLUCID_FUZZ_TARGETS
#undef PELLUCID_TARGET

namespace pellucid::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::string name;
  int (*run)(const std::uint8_t*, std::size_t);

  friend std::ostream& operator<<(std::ostream& out, const Target& target) {
    return out << target.name;
  }
};

std::vector<Target> targets() {
#define PELLUCID_TARGET(name) {#name, fuzz_##name},
  return {PELLUCID_FUZZ_TARGETS};
#undef PELLUCID_TARGET
}

const fs::path folder = PELLUCID_SOURCE_DIR "/fuzz";

std::vector<fs::path> corpus_of(const std::string& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder / "corpus" / target))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class UnitFuzzCorpus : public ::testing::TestWithParam<Target> {};

TEST_P(UnitFuzzCorpus, IsReadOrRefusedInOneLine) {
  const Target& target = GetParam();
  const Outcome before = outcome();
  for (const fs::path& file : corpus_of(target.name)) {
    SCOPED_TRACE(file.string());
    const std::string content = read_text(file);
    const Bytes bytes = bytes_of(content);
    EXPECT_EQ(target.run(bytes.data(), bytes.size()), 0);
  }
  EXPECT_GE(outcome().accepted - before.accepted, 2u) << "the corpus has rotted";
  EXPECT_GE(outcome().refused - before.refused, 1u) << "nothing wrong is in the corpus";
}

TEST_P(UnitFuzzCorpus, CutAnywhereIsReadOrRefused) {
  for (const fs::path& file : corpus_of(GetParam().name)) {
    const std::string content = read_text(file);
    const std::size_t step = std::max<std::size_t>(content.size() / 50, 1);
    for (std::size_t size = 0; size < content.size(); size += step) {
      const std::vector<std::uint8_t> cut(content.begin(), content.begin() + std::ptrdiff_t(size));
      EXPECT_EQ(GetParam().run(cut.data(), cut.size()), 0);
    }
  }
}

TEST_P(UnitFuzzCorpus, HasADictionary) {
  EXPECT_TRUE(fs::is_regular_file(folder / "dictionaries" / (GetParam().name + ".dict")));
}

INSTANTIATE_TEST_SUITE_P(Targets, UnitFuzzCorpus, ::testing::ValuesIn(targets()),
                         [](const auto& target) { return target.param.name; });

}  // namespace
}  // namespace pellucid::fuzz
