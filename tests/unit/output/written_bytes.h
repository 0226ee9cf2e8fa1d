// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace orthoball {

/// The number at the beginning, which is taken away.
template <class T>
T take(std::string_view& bytes) {
  T number{};
  if (bytes.size() < sizeof(T)) {
    ADD_FAILURE() << "the file ends early";
    return number;
  }
  std::memcpy(&number, bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
  return number;
}

/// What base64 text stands for.
inline std::string decoded(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
    }
  }
  return bytes;
}

/// The bytes of the DataArray of a name, checked against the size written before them.
inline std::string data_array(const std::string& vtu, const std::string& name) {
  const std::size_t at = vtu.find("Name=\"" + name + "\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = vtu.find('>', at) + 1;
  const std::string text = vtu.substr(begin, vtu.find('<', begin) - begin);
  const std::string header = decoded(text.substr(0, 12));
  std::string_view size = header;
  const auto expected = take<std::uint64_t>(size);
  const std::string bytes = decoded(text.substr(12));
  EXPECT_EQ(bytes.size(), expected) << name;
  return bytes;
}

/// The numbers of that array.
template <class T>
std::vector<T> numbers(const std::string& vtu, const std::string& name) {
  const std::string bytes = data_array(vtu, name);
  std::vector<T> result;
  for (std::string_view left = bytes; !left.empty();) result.push_back(take<T>(left));
  return result;
}

}  // namespace orthoball
