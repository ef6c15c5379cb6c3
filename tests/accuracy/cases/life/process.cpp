#include "accuracy/cases/life/process.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tumble::accuracy {

namespace {

constexpr rlim_t kSeconds = 20;

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(what, &both);
}

[[noreturn]] void work_and_end(const std::function<std::string()>& work, int into) {
  limit(RLIMIT_CPU, kSeconds);
  limit(RLIMIT_CORE, 0);
  std::string answer;
  try {
    answer = work();
  } catch (...) {
    answer.clear();
  }
  for (std::size_t done = 0; done < answer.size();) {
    const ssize_t written = write(into, answer.data() + done, answer.size() - done);
    if (written <= 0) _exit(1);
    done += static_cast<std::size_t>(written);
  }
  _exit(0);
}

}  // namespace

std::optional<std::string> in_new_process(const std::function<std::string()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) work_and_end(work, ends[1]);
  close(ends[1]);
  std::string answer;
  char buffer[4096];
  for (ssize_t got = 0; child > 0 && (got = read(ends[0], buffer, sizeof buffer)) > 0;) answer.append(buffer, static_cast<std::size_t>(got));
  close(ends[0]);
  int status = 1;
  if (child > 0) waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::optional(answer) : std::nullopt;
}

}  // namespace tumble::accuracy
