// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <system_error>

#include "app/commands.h"
#include "app/manual/manual_options.h"
#include "core/error.h"
#include "core/machine/build_info.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

/// Exit codes of the command line; scripts rely on them.
enum ExitCode { done = 0, work_failed = 1, input_wrong = 2 };

int complain(const std::exception& error, ExitCode code) {
  std::cerr << "pellucid: " << one_line(error.what()) << '\n';
  return code;
}

/// std::cout does not keep why it failed.
bool reader_has_gone() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

/// What a full disk or a closed descriptor has kept from being printed is a failure; that a reader
/// of a pipe has seen enough is none.
int flushed(int code) {
  errno = 0;
  const bool printed = std::fflush(stdout) == 0 && std::cout.flush().good() && !std::ferror(stdout);
  const int why = errno;
  if (printed || why == EPIPE || code != done || reader_has_gone()) return code;
  std::cerr << "pellucid: cannot write to the standard output: "
            << (why ? std::strerror(why) : "it takes no more") << '\n';
  return work_failed;
}

/// The limit holds while `limit` lives. Runs before any command does.
void limit_threads(int threads, std::optional<tbb::global_control>& limit) {
  if (threads == 0) return;
  limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
  ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);  // the software GL rasterizer
}

/// CLI11 says of a command that is none only that one is required.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw InputError(unknown_name("command", argv[1], known));
}

int run(int argc, char** argv) {
  CLI::App app{
      "Renders transparent flow visualizations exactly and by order-independent methods,\n"
      "and says how far each is from the truth and what it costs.",
      "pellucid"};
  app.set_version_flag("--version",
                       std::string("pellucid ") + build_version + " (" + build_commit + ")");
  app.require_subcommand(1);
  GlobalOptions globals;
  globals.command_line = fmt::format("{}", fmt::join(argv, argv + argc, " "));
  add_study_command(app, globals);
  add_render_command(app, globals);
  add_merge_command(app, globals);
  add_frames_command(app, globals);
  add_compare_command(app, globals);
  add_pack_command(app, globals);
  add_figure_command(app, globals);
  add_trace_command(app, globals);
  add_tune_command(app, globals);
  add_export_command(app, globals);
  add_conform_command(app, globals);
  add_data_command(app, globals);
  add_info_command(app, globals);
  add_crossings_command(app, globals);
  add_view_command(app, globals);
  add_list_command(app, globals);
  add_manual_options(app);
  std::optional<tbb::global_control> thread_limit;
  app.parse_complete_callback([&] { limit_threads(globals.threads, thread_limit); });
  try {
    check_command(app, argc, argv);
    app.parse(argc, argv);
    return done;
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::RuntimeError& exit) {  // a command that picks its own exit code
    return exit.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return complain(error, input_wrong);
  } catch (const InputError& error) {
    return complain(error, input_wrong);
  } catch (const std::filesystem::filesystem_error& error) {  // of a path: a circle of links
    return complain(error, input_wrong);
  } catch (const WorkError& error) {
    return complain(error, work_failed);
  } catch (const std::system_error& error) {  // by fmt: the output takes no more
    return error.code() == std::errc::broken_pipe ? done : complain(error, work_failed);
  } catch (const std::bad_alloc&) {
    std::cerr << "pellucid: out of memory\n";
    return work_failed;
  } catch (const std::exception& error) {
    return complain(error, work_failed);
  }
}

}  // namespace
}  // namespace pellucid::app

// What the last catch prints may throw: then there is nobody left to tell.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of a file's size fails what is written, by EFBIG
  return pellucid::app::flushed(pellucid::app::run(argc, argv));
}
