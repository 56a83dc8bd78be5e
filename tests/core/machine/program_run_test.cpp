// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/program_run.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <tbb/task_group.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/parallel.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class UnitProgramRun : public ::testing::Test {
 protected:
  ProgramRun run(const std::string& script, double timeout = 60) const {
    return run_program("/bin/sh", {"sh", "-c", script},
                       {folder_.path(), folder_ / "out", folder_ / "err"}, timeout);
  }
  testing::TemporaryFolder folder_;
};

/// Ends a process that runs `work` by the signal, once the file is there, and gives its guardian
/// some time.
template <class Work>
void end_while_running(const Work& work, const std::filesystem::path& begun, int signal) {
  const pid_t here = ::fork();
  if (here == 0) {
    work();
    ::_exit(0);
  }
  while (!std::filesystem::exists(begun))
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // until the guardian waits
  ::kill(here, signal);
  ::waitpid(here, nullptr, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
}

TEST_F(UnitProgramRun, KeepsWhatIsPrintedAndHowItEnds) {
  const ProgramRun run = this->run("pwd; echo wrong >&2; exit 3");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_FALSE(run.succeeded());
  EXPECT_EQ(run.failure(), "ended with code 3");
  EXPECT_EQ(read_text(folder_ / "out"), folder_.path().string() + "\n");
  EXPECT_EQ(read_text(folder_ / "err"), "wrong\n");
  EXPECT_TRUE(this->run("exit 0").succeeded());
}

TEST_F(UnitProgramRun, HasNoInputAndSeesNoShell) {
  EXPECT_TRUE(run("! read line").succeeded());
  run_program("/bin/echo", {"echo", "$HOME", "a  b", ";"},
              {folder_.path(), folder_ / "out", folder_ / "err"}, 60);
  EXPECT_EQ(read_text(folder_ / "out"), "$HOME a  b ;\n");
}

TEST_F(UnitProgramRun, TellsASignalAndWhatCannotBeStarted) {
  EXPECT_THAT(run("kill -SEGV $$").failure(), HasSubstr("Segmentation"));
  write_text(folder_ / "empty", "no program");
  EXPECT_THROW(run_program(folder_ / "empty", {"empty"},
                           {folder_.path(), folder_ / "out", folder_ / "err"}, 60),
               WorkError);
}

/// What a program has started goes with it, also when it has ended by itself.
TEST_F(UnitProgramRun, EndsAProgramAndItsChildrenInTime) {
  const ProgramRun run = this->run("(sleep 0.4; touch late) & sleep 60", 0.1);
  EXPECT_TRUE(run.timed_out);
  EXPECT_LT(run.seconds, 30);
  EXPECT_THAT(run.failure(), HasSubstr("after 0.1 s, its limit"));
  EXPECT_TRUE(this->run("(sleep 0.4; touch late) &").succeeded());
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "late"));
}

/// A script's programs, too, go with this process, whatever ends it.
TEST_F(UnitProgramRun, GoesWithThisProcessAndSoDoItsChildren) {
  for (const int signal : {SIGTERM, SIGKILL}) {
    std::filesystem::remove(folder_ / "begun");
    end_while_running([&] { run("(sleep 1; touch late) & touch begun; wait"); }, folder_ / "begun",
                      signal);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "late")) << signal;
  }
}

TEST_F(UnitProgramRun, ATemporaryFolderGoesWithThisProcess) {
  for (const bool is_temporary : {true, false}) {
    const std::filesystem::path place = folder_ / (is_temporary ? "temporary" : "kept");
    std::filesystem::create_directory(place);
    const ProgramPlace in{place, place / "out", place / "err", is_temporary};
    end_while_running(
        [&] {
          run_program("/bin/sh", {"sh", "-c", "touch begun; sleep 60"}, in, 60);
        },
        place / "begun", SIGINT);
    EXPECT_EQ(std::filesystem::exists(place), !is_temporary);
  }
}

TEST_F(UnitProgramRun, IsEndedWhenItsWorkIsCancelled) {
  tbb::task_group_context context;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    context.cancel_group_execution();
  });
  bool was_cancelled = false;
  const auto begin = std::chrono::steady_clock::now();
  tbb::task_group group(context);
  group.run_and_wait([&] {
    try {
      run("sleep 60");
    } catch (const Cancelled&) {
      was_cancelled = true;
    }
  });
  later.join();
  EXPECT_TRUE(was_cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST_F(UnitProgramRun, FindsAProgramByItsPathOrOnThePath) {
  EXPECT_EQ(find_program("sh", folder_.path()).filename(), "sh");
  EXPECT_EQ(find_program("./mine", folder_.path()), "");
  write_text(folder_ / "mine", "#!/bin/sh\n");
  EXPECT_EQ(find_program("./mine", folder_.path()), "");
  std::filesystem::permissions(folder_ / "mine", std::filesystem::perms::owner_all);
  EXPECT_EQ(find_program("./mine", folder_.path()), folder_ / "mine");
  EXPECT_EQ(find_program("mine", folder_.path()), "");
}

TEST(UnitSplitCommand, SplitsAtSpacesOutsideOfQuotes) {
  EXPECT_THAT(split_command(" a  'b c'd \"\" \"it's\""), ElementsAre("a", "b cd", "", "it's"));
  EXPECT_THROW(split_command("a 'b"), InputError);
  EXPECT_THROW(split_command("  "), InputError);
}

}  // namespace
}  // namespace pellucid
