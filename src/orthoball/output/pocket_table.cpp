// SPDX-License-Identifier: MIT
#include "orthoball/output/pocket_table.h"

#include <cstdint>

namespace orthoball {

std::string_view pocket_kind(const Pocket& pocket) {
  return pocket.mouths.empty() ? "void" : pocket.mouths.size() == 1 ? "pocket" : "channel";
}

void write_pockets_csv(ByteSink& sink, std::span<const Pocket> pockets) {
  sink.text("pocket,kind,volume,area,depth,atoms,mouths,mouth_areas\n");
  std::int64_t number = 0;
  for (const Pocket& pocket : pockets) {
    sink.integer(++number);
    sink.text(",");
    sink.text(pocket_kind(pocket));
    for (const double measure : {pocket.volume, pocket.area}) {
      sink.text(",");
      sink.real(measure);
    }
    sink.text(",");
    if (pocket.depth) sink.real(*pocket.depth);
    std::string_view before = ",";
    for (const LiningBall& ball : pocket.lining) {
      sink.text(before);
      sink.integer(ball.row.row());
      before = " ";
    }
    if (pocket.lining.empty()) sink.text(before);
    sink.text(",");
    sink.integer(static_cast<std::int64_t>(pocket.mouths.size()));
    before = ",";
    for (const Mouth& mouth : pocket.mouths) {
      sink.text(before);
      sink.real(mouth.area);
      before = " ";
    }
    if (pocket.mouths.empty()) sink.text(before);
    sink.text("\n");
  }
  sink.flush();
}

}  // namespace orthoball
