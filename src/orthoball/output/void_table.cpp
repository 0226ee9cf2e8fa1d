// SPDX-License-Identifier: MIT
#include "orthoball/output/void_table.h"

#include <cstdint>
#include <string_view>

namespace orthoball {

template <int D>
void write_voids_csv(ByteSink& sink, std::span<const Void<D>> voids) {
  sink.text(D == 3 ? "void,volume,area,atoms,atom_areas,born,dies,x,y,z,radius\n"
                   : "void,volume,area,atoms,atom_areas,born,dies,x,y,radius\n");
  const auto write_real = [&](double number) {
    sink.text(",");
    sink.real(number + 0.0);  // no -0
  };
  std::int64_t number = 0;
  for (const Void<D>& hole : voids) {
    sink.integer(++number);
    write_real(hole.volume);
    write_real(hole.area);
    const auto write_lining = [&](const auto& write) {
      std::string_view before = ",";
      for (const LiningBall& ball : hole.lining) {
        sink.text(before);
        write(ball);
        before = " ";
      }
      if (hole.lining.empty()) sink.text(",");
    };
    write_lining([&](const LiningBall& ball) { sink.integer(ball.row.row()); });
    write_lining([&](const LiningBall& ball) { sink.real(ball.area + 0.0); });
    write_real(hole.born_alpha2);
    write_real(hole.dies_alpha2);
    const bool has_ball = hole.largest_ball_radius > 0.0;
    for (const double x : hole.largest_ball_centre) has_ball ? write_real(x) : sink.text(",");
    has_ball ? write_real(hole.largest_ball_radius) : sink.text(",");
    sink.text("\n");
  }
  sink.flush();
}

template void write_voids_csv<2>(ByteSink&, std::span<const Void<2>>);
template void write_voids_csv<3>(ByteSink&, std::span<const Void<3>>);

}  // namespace orthoball
