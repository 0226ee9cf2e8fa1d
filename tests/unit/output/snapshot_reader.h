// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace orthoball {

/// A file of packed arrays read back, plainly: docs/file_formats/snapshot.md.
class PackedReader {
 public:
  explicit PackedReader(const std::string& bytes) : bytes_(bytes) {
    if (bytes.substr(0, 8) != "OBsnap1\n") throw std::runtime_error("no magic");
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + 8, 8);
    header_ = nlohmann::json::parse(bytes.substr(16, size));
    begin_ = 16 + size;
  }

  [[nodiscard]] const nlohmann::json& header() const { return header_; }
  [[nodiscard]] bool has(const std::string& name) const {
    for (const auto& array : header_["arrays"]) {
      if (array["name"] == name) return true;
    }
    return false;
  }
  [[nodiscard]] const nlohmann::json& array(const std::string& name) const {
    for (const auto& array : header_["arrays"]) {
      if (array["name"] == name) return array;
    }
    throw std::runtime_error("no array " + name);
  }
  [[nodiscard]] std::vector<std::uint32_t> numbers(const std::string& name) const {
    auto numbers = words<std::uint32_t>(array(name));
    const std::size_t stride = array(name)["stride"];
    for (std::size_t i = 0; stride > 0 && i < numbers.size(); ++i) {
      const std::uint32_t d = numbers[i];
      const std::uint32_t difference = (d % 2 == 0) ? d / 2 : ~(d / 2);
      numbers[i] = difference + (i < stride ? 0 : numbers[i - stride]);
    }
    return numbers;
  }
  [[nodiscard]] std::vector<double> reals(const std::string& name) const {
    if (array(name)["type"] == "f64") return bit_copies<double, std::uint64_t>(name);
    const auto rounded = bit_copies<float, std::uint32_t>(name);
    return {rounded.begin(), rounded.end()};
  }

 private:
  template <class Word>
  [[nodiscard]] std::vector<Word> words(const nlohmann::json& array) const {
    const std::size_t length = array["length"], offset = array["offset"];
    std::vector<Word> words(length, 0);
    for (std::size_t byte = 0; byte < sizeof(Word); ++byte) {
      for (std::size_t i = 0; i < length; ++i) {
        const auto value =
            static_cast<unsigned char>(bytes_.at(begin_ + offset + byte * length + i));
        words[i] |= static_cast<Word>(Word{value} << (8 * byte));
      }
    }
    return words;
  }
  template <class Real, class Word>
  [[nodiscard]] std::vector<Real> bit_copies(const std::string& name) const {
    const auto found = words<Word>(array(name));
    std::vector<Real> reals(found.size());
    if (!found.empty()) std::memcpy(reals.data(), found.data(), sizeof(Word) * found.size());
    return reals;
  }

  std::string bytes_;
  nlohmann::json header_;
  std::size_t begin_ = 0;
};

}  // namespace orthoball
