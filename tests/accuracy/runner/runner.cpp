#include "accuracy/runner/runner.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "base/error.h"

namespace tumble::accuracy {

namespace {

// A row travels from a worker as its CSV line; the index of the try that begins, as "@7".
struct Job {
  const Case* c = nullptr;
  const EngineKind* engine = nullptr;
  std::size_t order = 0;
  int restarts = 0;
};

struct Worker {
  Job job;
  pid_t process = 0;
  int pipe = -1;
  std::string text;                 // read and not yet a line
  std::size_t begun = 0;
  bool begun_any = false, answered = true;
  double started = 0;               // wall, s
};

constexpr int kMostRestarts = 6;  // of one case on one engine

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Wall time after which a worker is taken to hang.
double patience(const Options& options) {
  return options.effort == Effort::quick ? 30 : options.effort == Effort::test ? 20 : budget(options) * 4 + 60;
}

class Runner {
 public:
  Runner(const Options& options, const std::string& version, const std::function<void(const std::vector<Row>&)>& so_far)
      : options_(options), version_(version), so_far_(so_far), started_(now()) {
    for (const Case& c : all_cases())
      for (const EngineKind& engine : engines()) {
        const auto wanted = [](const std::vector<std::string>& list, const std::string& name) {
          return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
        };
        if (!wanted(options.cases, c.id) || !wanted(options.engines, engine.name)) continue;
        jobs_.push_back({&c, &engine, jobs_.size()});
      }
    rows_.resize(jobs_.size());
  }

  std::vector<Row> run() {
    while (next_ < jobs_.size() || !workers_.empty()) {
      while (next_ < jobs_.size() && static_cast<int>(workers_.size()) < options_.jobs) start(jobs_[next_++], 0);
      wait();
    }
    progress(true);
    return all_rows();
  }

 private:
  std::vector<Row> all_rows() const {
    std::vector<Row> all;
    for (const auto& list : rows_) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  void end_job() {
    ++done_;
    if (so_far_) so_far_(all_rows());
  }

  void start(const Job& job, std::size_t first) {
    int ends[2];
    if (pipe(ends) != 0) fail("measure: no pipe: ", std::strerror(errno));
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process < 0) fail("measure: no process: ", std::strerror(errno));
    if (process == 0) {
      close(ends[0]);
      work(job, first, ends[1]);
    }
    close(ends[1]);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    Worker worker;
    worker.job = job;
    worker.process = process;
    worker.pipe = ends[0];
    worker.started = now();
    workers_.push_back(std::move(worker));
  }

  [[noreturn]] void work(const Job& job, std::size_t first, int out) {
    const auto send = [out](const std::string& line) {
      const std::string whole = line + "\n";
      for (std::size_t done = 0; done < whole.size();) {
        const ssize_t n = write(out, whole.data() + done, whole.size() - done);
        if (n <= 0) _exit(3);
        done += static_cast<std::size_t>(n);
      }
    };
    sweep(*job.c, *job.engine, options_, version_, first, [&](std::size_t index) { send("@" + std::to_string(index)); },
          [&](const Row& row) { send(csv_line(row)); });
    _exit(0);
  }

  void wait() {
    std::vector<pollfd> polls;
    for (const Worker& worker : workers_) polls.push_back({worker.pipe, POLLIN, 0});
    poll(polls.data(), polls.size(), 500);
    for (std::size_t i = workers_.size(); i-- > 0;) {
      Worker& worker = workers_[i];
      if (now() - worker.started > patience(options_)) kill(worker.process, SIGKILL);
      if (read_lines(worker)) continue;
      const Worker ended = worker;
      workers_.erase(workers_.begin() + static_cast<long>(i));
      finish(ended);
    }
    progress(false);
  }

  // False once the worker has closed its end.
  bool read_lines(Worker& worker) {
    char buffer[4096];
    for (;;) {
      const ssize_t n = read(worker.pipe, buffer, sizeof buffer);
      if (n == 0) return false;
      if (n < 0) return true;
      worker.text.append(buffer, static_cast<std::size_t>(n));
      for (std::size_t end; (end = worker.text.find('\n')) != std::string::npos; worker.text.erase(0, end + 1)) take(worker, worker.text.substr(0, end));
    }
  }

  void take(Worker& worker, const std::string& line) {
    worker.started = now();
    if (line.starts_with("@")) {
      worker.begun = static_cast<std::size_t>(std::atol(line.c_str() + 1));
      worker.begun_any = true;
      worker.answered = false;
      return;
    }
    worker.answered = true;
    rows_[worker.job.order].push_back(parse_csv_line(line));
  }

  void finish(const Worker& worker) {
    close(worker.pipe);
    int status = 0;
    waitpid(worker.process, &status, 0);
    if (worker.answered || !worker.begun_any) {
      if (status != 0 && !worker.begun_any) fail("measure: the worker of ", worker.job.c->id, " ended with status ", status, " before its first try");
      end_job();
      return;
    }
    // It died within a try: that try has failed, the rest goes on in a new process.
    const Try attempt = plan(*worker.job.c, *worker.job.engine, options_).at(worker.begun);
    Row row;
    row.version = version_;
    row.engine = worker.job.engine->name;
    row.id = worker.job.c->id;
    row.part = attempt.part->name;
    row.effort = effort_name(options_.effort);
    row.setting = attempt.is_default ? "default" : setting_name(attempt.knobs);
    row.knobs = attempt.knobs;
    row.goal = attempt.part->goal;
    row.error = worker.job.c->stability() ? 1e6 : 1;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    row.failed = signal == SIGKILL ? "hung: no result in " + std::to_string(static_cast<int>(patience(options_))) + " s"
                                   : "crashed: " + std::string(signal ? strsignal(signal) : "exit");
    rows_[worker.job.order].push_back(row);
    Job again = worker.job;
    if (++again.restarts <= kMostRestarts) start(again, worker.begun + 1);
    else end_job();
  }

  void progress(bool end) {
    const bool terminal = isatty(2);
    const double seconds = now() - started_;
    if (end) {
      if (terminal) std::fprintf(stderr, "\r\033[K");
      return;
    }
    if (seconds - told_ < (terminal ? 0.5 : 30)) return;
    told_ = seconds;
    const double share = static_cast<double>(done_) / static_cast<double>(std::max<std::size_t>(1, jobs_.size()));
    std::string names;
    for (const Worker& worker : workers_) names += " " + worker.job.c->id + "/" + worker.job.engine->name;
    const double left = share > 0 ? seconds / share - seconds : 0;
    std::fprintf(stderr, "%s%3.0f %%  %.0f s, about %.0f s left %s%s", terminal ? "\r\033[K" : "", share * 100, seconds, left, names.c_str(), terminal ? "" : "\n");
  }

  const Options& options_;
  std::string version_;
  const std::function<void(const std::vector<Row>&)>& so_far_;
  double started_, told_ = 0;
  std::vector<Job> jobs_;
  std::vector<std::vector<Row>> rows_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0, done_ = 0;
};

}  // namespace

std::vector<Row> run_all(const Options& options, const std::string& version, const std::function<void(const std::vector<Row>&)>& so_far) {
  for (const std::string& id : options.cases) {
    const bool known = std::any_of(all_cases().begin(), all_cases().end(), [&](const Case& c) { return c.id == id; });
    if (!known) fail("measure: no case '", id, "'; --list names them");
  }
  for (const std::string& name : options.engines) {
    const bool known = std::any_of(engines().begin(), engines().end(), [&](const EngineKind& e) { return e.name == name; });
    if (!known) fail("measure: no engine '", name, "'; there are tumble and stock");
  }
  return Runner(options, version, so_far).run();
}

}  // namespace tumble::accuracy
