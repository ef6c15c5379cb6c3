#include "cli/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <set>

namespace fs = std::filesystem;

namespace tumble::cli {

fs::path own_program() { return fs::read_symlink("/proc/self/exe"); }

fs::path source_tree(const std::string& call) {
  const char* given = std::getenv("TUMBLE_SOURCE");
  const fs::path tree = given && *given ? fs::path(given) : own_program().parent_path().parent_path().parent_path();
  if (!fs::is_directory(tree / "runtime") || !fs::is_directory(tree / "scripts"))
    throw Error(call + ": '" + tree.string() + "' is not Tumble's source tree; start ./tumble in a clone, or set TUMBLE_SOURCE to one");
  return tree;
}

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

namespace {

// In the child of a fork: becomes the program. Does not return.
void become(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

void read_lines(int file, const std::function<void(const std::string&)>& each_line) {
  std::string line;
  char buffer[4096];
  for (ssize_t count; (count = read(file, buffer, sizeof buffer)) > 0;)
    for (ssize_t i = 0; i < count; ++i) {
      if (buffer[i] != '\n') {
        line += buffer[i];
        continue;
      }
      each_line(line);
      line.clear();
    }
  if (!line.empty()) each_line(line);
}

}  // namespace

int run_program(const std::vector<std::string>& words, const std::function<void(const std::string&)>& each_line) {
  std::cout.flush();
  int ends[2] = {-1, -1};
  if (each_line && pipe(ends) != 0) throw Error("cannot start '" + words[0] + "': no pipe");
  const pid_t child = fork();
  if (child < 0) throw Error("cannot start '" + words[0] + "': no process");
  if (child == 0) {
    if (each_line) {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
    }
    become(words);
  }
  if (each_line) {
    close(ends[1]);
    read_lines(ends[0], each_line);
    close(ends[0]);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void show_messages(Runtime& runtime) {
  runtime.on_log([](LogLevel level, const std::string& text) {
    static const char* const kBefore[] = {"", "", "warning: ", "error: "};
    std::ostream& out = level == LogLevel::print ? std::cout : std::cerr;
    out << kBefore[static_cast<int>(level)] << text << std::endl;
  });
  // A failure that comes back after each restart or save is told once.
  const auto told = std::make_shared<std::set<std::string>>();
  runtime.on_script_error([told](const ScriptError& error) {
    std::cout.flush();
    if (!told->insert(error.text + error.traceback).second) return;
    std::cerr << error.text << '\n';
    if (!error.source.empty()) std::cerr << "  " << error.source << '\n';
    std::cerr << error.traceback << (error.traceback.empty() || error.traceback.ends_with('\n') ? "" : "\n");
  });
}

std::string count_text(std::int64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string game_name(const std::string& game) {
  fs::path path = fs::weakly_canonical(game);
  if (path.filename().empty()) path = path.parent_path();
  const bool ending = path.extension() == ".tumble" || path.extension() == ".lua";
  return (ending ? path.stem() : path.filename()).string();
}

void write_file(const fs::path& file, const std::string& text, const std::string& call) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw Error(call + ": '" + file.string() + "' cannot be written; look at the folder's permissions and free space");
}

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace tumble::cli
