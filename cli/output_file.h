// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>

#include "orthoball/output/byte_sink.h"

/// Whoever read standard output needs no more, as `head` does. That is to be said by the status
/// only.
class ReaderGone : public orthoball::OutputError {
 public:
  using OutputError::OutputError;
};

/// Where a command's data goes: standard output for "-", otherwise a file that appears whole or not
/// at all. It is written beside its place under another name, takes its place on `commit` with the
/// permissions of the file that was there, and is removed if that never comes, also when
/// SIGINT, SIGTERM, SIGHUP, SIGQUIT or SIGXCPU ends the program. A device or pipe (/dev/full, a
/// FIFO) is written directly. One at a time.
class OutputFile {
 public:
  /// @throws orthoball::OutputError that says why nothing can be written there.
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  [[nodiscard]] std::ostream& stream() { return is_standard_ ? standard() : file_; }
  /// Says that writing has failed, with the system's reason.
  /// @throws orthoball::OutputError always; ReaderGone where that is why.
  [[noreturn]] void fail() const { fail("could not be written"); }
  /// Everything is written.
  /// @throws orthoball::OutputError if it was not.
  void commit();

 private:
  static std::ostream& standard();
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::string temporary_;  // empty where the file is written directly
  bool is_standard_;
  std::ofstream file_;
};

/// Lets `write` fill a sink for the output at `path` and commits it.
/// @param missing  what the sink writes for a number that is not finite.
/// @return how many numbers were not finite.
/// @throws orthoball::OutputError that names the output and the reason.
std::size_t write_output(const std::string& path, const std::string& missing,
                         const std::function<void(orthoball::ByteSink&)>& write);

/// Whether two outputs, files that need not be there or "-", are the same.
[[nodiscard]] bool is_same_output(const std::string& one, const std::string& other);

/// The ending of a file name in lower case, without the dot; empty where there is none.
[[nodiscard]] std::string ending_of(const std::string& path);
