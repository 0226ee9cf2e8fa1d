// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

#include "orthoball/output/byte_sink.h"

namespace orthoball {

/// A stream whose bytes go on to a sink as one gzip file: a step between two sinks. The same bytes
/// in give the same bytes out; the file has no name and no time. Does not own the sink.
class GzipOutput : public std::ostream {
 public:
  explicit GzipOutput(ByteSink& to);
  GzipOutput(const GzipOutput&) = delete;
  GzipOutput& operator=(const GzipOutput&) = delete;
  ~GzipOutput() override;

  /// Ends the file. Flushes nothing but itself.
  /// @throws OutputError
  void finish();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
};

/// A stream whose bytes go on to a sink as base64. Does not own the sink.
class Base64Output : public std::ostream {
 public:
  /// In one line.
  explicit Base64Output(ByteSink& to);
  /// In parts of about `length` characters, a multiple of four each, and `between` between them.
  Base64Output(ByteSink& to, std::string between, std::size_t length);
  Base64Output(const Base64Output&) = delete;
  Base64Output& operator=(const Base64Output&) = delete;
  ~Base64Output() override;

  /// Writes the last bytes with their padding.
  /// @throws OutputError
  void finish();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace orthoball
