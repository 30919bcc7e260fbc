// Runs a libFuzzer target without libFuzzer: every kept input, then mutations of them, the same ones in every
// run. TARGET [-runs=N] [-seed=N] [-max_len=N] [-timeout=SECONDS] FOLDER_OR_FILE…
// A crash keeps its input in the file crash-SEED-RUN and prints the command that runs it again; so does an
// input that takes more processor time than the timeout.

#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include "mutate.h"

// The sanitizers read these when they begin. They report every fault, signals among them, and then abort,
// which leaves SIGABRT to keepInputOnCrash().
extern "C" const char* __asan_default_options() { return "abort_on_error=1:handle_segv=2:handle_sigfpe=2"; }
extern "C" const char* __tsan_default_options() { return __asan_default_options(); }
extern "C" const char* __ubsan_default_options() { return __asan_default_options(); }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

using carom::test::Bytes;

struct Options {
  std::size_t runs = 20000, seed = 1, longest = 4096, timeout_s = 0;
  std::vector<std::filesystem::path> folders;
  std::string program;
};

Options read(int argc, char** argv) {
  Options options;
  options.program = std::filesystem::absolute(argv[0]);
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const auto number = [&](std::string_view name, std::size_t& value) {
      if (!argument.starts_with(name)) return false;
      std::from_chars(argument.data() + name.size(), argument.data() + argument.size(), value);
      return true;
    };
    if (number("-runs=", options.runs) || number("-seed=", options.seed) ||
        number("-max_len=", options.longest) || number("-timeout=", options.timeout_s)) {
      continue;
    }
    options.folders.emplace_back(argument);
  }
  return options;
}

std::vector<std::filesystem::path> keptFiles(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> files;
  for (const auto& folder : folders) {
    if (!is_directory(folder)) {
      files.push_back(folder);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The input being tried, ready to be written by a signal handler, which may neither allocate nor format.
struct Current {
  const Bytes* input = nullptr;
  bool isKept = false;  ///< the file is there already
  char file[4096]{}, command[8192]{};
} current;

/// Sends SIGPROF after this much processor time; 0: never.
void limitTime(std::size_t timeout_s) {
  itimerval limit{};
  limit.it_value.tv_sec = static_cast<time_t>(timeout_s);
  setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Tries an input; `file` is where it is kept or, if the target crashes, will be kept.
void tryInput(const Bytes& input, const std::string& file, const Options& options, bool isKept) {
  current.input = nullptr;
  std::snprintf(current.file, sizeof current.file, "%s", file.c_str());
  std::snprintf(current.command, sizeof current.command, "\ncrashed; again: %s -runs=0 -timeout=%zu %s\n",
                options.program.c_str(), options.timeout_s, file.c_str());
  current.isKept = isKept;
  current.input = &input;
  limitTime(options.timeout_s);
  LLVMFuzzerTestOneInput(input.data(), input.size());
  limitTime(0);
  current.input = nullptr;
}

void writeAll(int file, const void* bytes, std::size_t size) {
  for (const char* at = static_cast<const char*>(bytes); size > 0;) {
    const ssize_t written = write(file, at, size);
    if (written <= 0) return;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

/// Writes the current input and prints the command that runs it again. Calls only what a signal handler may
/// call (signal-safety(7)).
void keepInput() {
  const Bytes* input = current.input;
  if (!input) return;
  current.input = nullptr;
  if (!current.isKept) {
    const int file = open(current.file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    writeAll(file, input->data(), input->size());
    close(file);
  }
  writeAll(STDERR_FILENO, current.command, std::char_traits<char>::length(current.command));
}

/// Keeps the input on every signal of a fault, and of time that is up; an exception that nobody catches ends
/// in SIGABRT.
void keepInputOnCrash() {
  static char stack[1 << 16];  // a full stack is a fault, too, and leaves no room for the handler
  const stack_t alternative{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
  sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_handler = [](int signal) {
    keepInput();
    raise(signal);  // with SA_RESETHAND: ends as it would have ended
  };
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGPROF}) {
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read(argc, argv);
  const std::vector<std::filesystem::path> files = keptFiles(options.folders);
  if (files.empty()) {
    std::fprintf(stderr, "no kept inputs found, expected a folder of them\n");
    return 1;
  }
  keepInputOnCrash();
  std::vector<Bytes> inputs;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    tryInput(inputs.back(), absolute(file), options, true);
  }
  const std::string crash = std::filesystem::current_path() / ("crash-" + std::to_string(options.seed) + "-");
  std::mt19937_64 random(options.seed);
  for (std::size_t run = 0; run < options.runs; ++run) {
    const Bytes& one = inputs[random() % inputs.size()];
    const Bytes& other = inputs[random() % inputs.size()];
    Bytes input = carom::test::mutated(one, other, random);
    input.resize(std::min(input.size(), options.longest));
    tryInput(input, crash + std::to_string(run), options, false);
  }
  std::printf("%zu kept inputs, %zu mutations\n", inputs.size(), options.runs);
  return 0;
}
