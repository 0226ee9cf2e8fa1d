// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

#include "orthoball/error.h"
#include "orthoball/input/read.h"
#include "orthoball/input/source.h"

namespace orthoball::fuzz {

/// Gives arbitrary bytes to one reader. It may refuse them with one of our errors and a message; a
/// reading must be consistent: labels for every row or for none.
inline int read_bytes(Reading (*reader)(const Source&, const ReadOptions&),
                      const std::uint8_t* data, std::size_t size) {
  const Source source{"input", std::string(reinterpret_cast<const char*>(data), size)};
  try {
    const Reading reading = reader(source, {});
    const std::size_t rows = reading.points.size();
    const SiteLabels& labels = reading.labels;
    for (const std::size_t count : {labels.line.size(), labels.element.size(), labels.atom.size(),
                                    labels.residue.size(), labels.chain.size()}) {
      if (count != 0 && count != rows) __builtin_trap();
    }
  } catch (const ParseError& error) {
    if (std::string(error.what()).empty()) __builtin_trap();
  } catch (const InputError&) {
  } catch (const LimitError&) {
  }
  return 0;
}

}  // namespace orthoball::fuzz
