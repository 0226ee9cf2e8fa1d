// SPDX-License-Identifier: MIT
#include "cli/output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <iostream>
#include <utility>

namespace {

// What a signal must remove; null for nothing. Names are kept to the end, so that a signal that any
// thread takes finds a whole one.
std::atomic<const char*> unfinished = nullptr;
// Whether a file is being made whose name is not yet among them.
std::atomic<bool> is_naming = false;
static_assert(std::atomic<const char*>::is_always_lock_free &&
              decltype(is_naming)::is_always_lock_free);

// Only what POSIX allows in a handler. The signal, raised again, has its usual effect once this
// returns: the handler was reset when it was called. The thread that makes a file takes no signals
// until its name is known, and another that takes one waits for that.
extern "C" void remove_unfinished(int signal) {
  while (is_naming) {
  }
  if (const char* const name = unfinished.load()) unlink(name);
  raise(signal);
}

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

void remove_on_signals() {
  for (const int signal : kSignals) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_DFL) continue;  // ignored, as nohup does
    action.sa_handler = remove_unfinished;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

// While one lives, the signals wait for this thread.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ours;
    sigemptyset(&ours);
    for (const int signal : kSignals) sigaddset(&ours, signal);
    pthread_sigmask(SIG_BLOCK, &ours, &before_);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

// A file of its own beside `path`, empty. Nothing where none can be made; errno says why.
std::string temporary_beside(const std::filesystem::path& path) {
  static std::deque<std::string> names;
  if (names.empty()) remove_on_signals();
  std::string& name = names.emplace_back(
      (path.parent_path() / ("." + path.filename().string() + ".XXXXXX")).string());
  // While mkstemp tries names, they may be those of others' files; no handler is to read them.
  const SignalsWait waiting;
  is_naming = true;
  const int descriptor = mkstemp(name.data());
  if (descriptor >= 0) unfinished = name.c_str();
  is_naming = false;
  if (descriptor < 0) return {};
  close(descriptor);
  return name;
}

// mkstemp's files are for the owner only. Ours are for those whom the file that is replaced was
// for, or for those whom any other new file is for. A program that it was is not to run as its
// owner any more. Where its group cannot be kept, another group may do no more than all others.
void open_to_others(const std::string& temporary, const std::string& path) {
  struct stat replaced = {};
  mode_t mode = 0;
  if (stat(path.c_str(), &replaced) == 0) {
    mode = replaced.st_mode & 0777U;
    const bool keeps_group = chown(temporary.c_str(), static_cast<uid_t>(-1), replaced.st_gid) == 0;
    if (!keeps_group) mode &= 0707U | (mode & 07U) << 3U;
  } else {
    const mode_t mask = umask(0);
    umask(mask);
    mode = 0666U & ~mask;
  }
  chmod(temporary.c_str(), mode);
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), is_standard_(path_ == "-") {
  if (is_standard_) return;
  std::error_code error;
  const auto status = std::filesystem::status(path_, error);
  if (std::filesystem::is_directory(status)) {
    errno = EISDIR;
    fail("cannot be written");
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    file_.open(path_, std::ios::binary);
  } else {
    // A link's target is replaced, not the link.
    const auto target = std::filesystem::weakly_canonical(path_, error);
    if (!error) path_ = target.string();
    temporary_ = temporary_beside(path_);
    if (temporary_.empty()) fail("cannot be written");
    file_.open(temporary_, std::ios::binary);
    open_to_others(temporary_, path_);
  }
  if (!file_) fail("cannot be written");
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  std::remove(temporary_.c_str());
  unfinished = nullptr;
}

void OutputFile::commit() {
  errno = 0;
  stream().flush();
  if (!is_standard_) file_.close();
  if (!stream()) fail();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be written");
  unfinished = nullptr;
  temporary_.clear();
}

std::ostream& OutputFile::standard() { return std::cout; }

void OutputFile::fail(const std::string& what) const {
  const int code = errno;
  const std::string message = (is_standard_ ? "standard output" : path_) + ": " + what +
                              (code == 0 ? "" : ": " + std::string(std::strerror(code)));
  if (is_standard_ && code == EPIPE) throw ReaderGone(message);
  throw orthoball::OutputError(message);
}

std::size_t write_output(const std::string& path, const std::string& missing,
                         const std::function<void(orthoball::ByteSink&)>& write) {
  OutputFile file(path);
  orthoball::ByteSink sink(file.stream(), missing);
  try {
    errno = 0;
    write(sink);
  } catch (const orthoball::OutputError&) {
    file.fail();
  }
  file.commit();
  return sink.missing_count();
}

bool is_same_output(const std::string& one, const std::string& other) {
  if (one == other) return true;
  if (one == "-" || other == "-") return false;
  std::error_code error;  // then the path is empty
  const auto place = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  const std::filesystem::path first = place(one);
  return !first.empty() && first == place(other);
}

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}
