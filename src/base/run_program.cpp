// Runs a program without a shell, so that no file name can turn into a command.
#include "robot/run_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

extern char** environ;

namespace collision_hulls {
namespace {

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

// A file without a name. Unlike a pipe it takes any amount of output while nobody reads.
class Output {
 public:
  Output() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) fail(errno, "temporary file");
  }
  int descriptor() const { return fileno(file_.get()); }

  std::string text() const {
    std::string text;
    std::rewind(file_.get());
    char buffer[4096];
    while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, file_.get())) text.append(buffer, size);
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

class FileActions {
 public:
  FileActions(const Output& out, const Output& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors.descriptor(), STDERR_FILENO);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

int waitFor(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) fail(errno, "waiting for a program");
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::optional<ProgramResult> runProgram(const std::vector<std::string>& arguments) {
  const Output out, errors;
  const FileActions actions(out, errors);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t process = 0;
  const int error = posix_spawnp(&process, argv[0], actions.get(), nullptr, argv.data(), environ);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) fail(error, arguments.front());
  const int status = waitFor(process);
  return ProgramResult{status, out.text(), errors.text()};
}

}  // namespace collision_hulls
