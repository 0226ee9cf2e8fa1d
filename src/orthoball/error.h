// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace orthoball {

/// The caller's numbers are not what the function accepts. The message says which row, what is
/// wrong with it and what would be right. Whatever threw it has changed nothing.
class InputError : public std::invalid_argument {
 public:
  /// What kind of mistake it is, for programs; the message is for people.
  enum class Reason {
    not_finite,      ///< a coordinate, radius or weight is NaN or infinite
    wrong_size,      ///< the arrays' lengths do not fit each other or the dimension
    wrong_argument,  ///< an option outside its range
    imaginary_ball,  ///< a radius or weight is below 0 where balls must be real
  };
  static constexpr std::size_t kNoRow = static_cast<std::size_t>(-1);

  InputError(Reason reason, std::size_t row, const std::string& message)
      : std::invalid_argument(message), reason_(reason), row_(row) {}

  [[nodiscard]] Reason reason() const { return reason_; }
  /// The 0-based input row at fault, kNoRow where no single row is.
  [[nodiscard]] std::size_t row() const { return row_; }

 private:
  Reason reason_;
  std::size_t row_;
};

/// A file is not what its format says. The message reads `FILE:LINE: what is wrong; what would be
/// right`; binary formats name the byte offset instead of a line.
class ParseError : public std::runtime_error {
 public:
  /// @param line  1-based; 0 where the whole file is meant or the message names a byte offset.
  ParseError(std::string file, std::size_t line, const std::string& message)
      : std::runtime_error(line == 0 ? file + ": " + message
                                     : file + ":" + std::to_string(line) + ": " + message),
        file_(std::move(file)),
        line_(line) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::string file_;
  std::size_t line_;
};

/// More of something than the data structures can count, or than a stated limit allows.
class LimitError : public std::length_error {
 public:
  using std::length_error::length_error;
};

}  // namespace orthoball
