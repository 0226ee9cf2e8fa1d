// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace orthoball::matchers {

template <class T>
[[nodiscard]] std::string described(const T& value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}
template <class A, class B>
[[nodiscard]] std::string described(const std::pair<A, B>& pair) {
  return described(pair.first) + ":" + described(pair.second);
}
template <class T>
[[nodiscard]] std::string described(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() > 1 ? " " : "") + described(value);
  return text + "]";
}

/// Compares what is with what should be, and adds a sentence to a list where they differ.
class Comparison {
 public:
  explicit Comparison(std::vector<std::string>& found) : found_(found) {}

  template <class T>
  void operator()(const std::string& what, const T& actual, const T& expected) {
    if (actual == expected) return;
    found_.push_back(what + ": " + described(actual) + " instead of " + described(expected));
  }

 private:
  std::vector<std::string>& found_;
};

}  // namespace orthoball::matchers
