// SPDX-License-Identifier: MIT
#include "orthoball/output/alpha_text.h"

#include <fmt/format.h>

#include "orthoball/signatures/notable_alphas.h"

namespace orthoball {

template <int D>
std::string scale_text(const Filtration<D>& filtration) {
  const std::uint32_t size = filtration.spectrum_size();
  if (size == 0) return "there are no sites";
  std::string text = fmt::format("the first simplex enters at alpha2 {}, the last at {}",
                                 filtration.alpha2(1), filtration.alpha2(size));
  for (const NotableAlpha& notable : notable_alphas(filtration)) {
    if (!notable.index || (notable.name != "connected" && notable.name != "solid")) continue;
    text += fmt::format("; {} at {}", notable.name == "solid" ? "solid" : "in one piece",
                        filtration.alpha2(*notable.index));
  }
  return text;
}

template std::string scale_text(const Filtration<2>&);
template std::string scale_text(const Filtration<3>&);

}  // namespace orthoball
