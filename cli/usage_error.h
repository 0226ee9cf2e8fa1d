// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

/// The command line itself is wrong: options that exclude each other, a number that is none.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
