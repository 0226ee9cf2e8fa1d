// SPDX-License-Identifier: MIT
#include "orthoball/output/page.h"

#include <cstddef>
#include <string>

#include "orthoball/error.h"
#include "orthoball/output/encoded_output.h"

namespace orthoball {
namespace {

constexpr std::string_view kTitle = "%ORTHOBALL_TITLE%", kSnapshot = "%ORTHOBALL_SNAPSHOT%",
                           kNextPart = "</script>\n<script type=\"application/gzip\">";
constexpr std::size_t kPart = std::size_t{1} << 27U;  // browsers lose elements of half a gigabyte

std::string html_text(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else {
      html += c;
    }
  }
  return html;
}

}  // namespace

template <int D>
void write_page(ByteSink& sink, std::string_view page, const Filtration<D>& filtration,
                const WeightedPoints& points, const SiteLabels& labels, const SnapshotFacts& facts,
                Threads threads) {
  const auto write_until = [&](std::string_view place) {
    const std::size_t end = page.find(place);
    if (end == std::string_view::npos) {
      throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                       "the page has no place " + std::string(place) + "; the viewer's has");
    }
    sink.text(page.substr(0, end));
    page.remove_prefix(end + place.size());
  };
  write_until(kTitle);
  sink.text(html_text(facts.source));
  write_until(kSnapshot);
  {
    Base64Output text(sink, std::string(kNextPart), kPart);
    ByteSink packed(text);
    GzipOutput gzip(packed);
    ByteSink snapshot(gzip, "null");
    write_snapshot(snapshot, filtration, points, labels, facts, threads);
    gzip.finish();
    packed.flush();
    text.finish();
  }
  sink.text(page);
  sink.flush();
}

template void write_page<2>(ByteSink&, std::string_view, const Filtration<2>&,
                            const WeightedPoints&, const SiteLabels&, const SnapshotFacts&,
                            Threads);
template void write_page<3>(ByteSink&, std::string_view, const Filtration<3>&,
                            const WeightedPoints&, const SiteLabels&, const SnapshotFacts&,
                            Threads);

}  // namespace orthoball
