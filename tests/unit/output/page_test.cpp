// SPDX-License-Identifier: MIT
#include "orthoball/output/page.h"

#include <gtest/gtest.h>

#include <string>

#include "orthoball/output/encoded_output.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

TEST(Page, HoldsTheTitleAndTheSnapshotInTheirPlaces) {
  const Shapes<2> shapes({0, 0, 1, 0, 0, 1});
  const SnapshotFacts facts{.source = "a<b&c.csv"};
  const std::string snapshot = written([&](ByteSink& sink) {
    Base64Output text(sink);
    ByteSink packed(text);
    GzipOutput gzip(packed);
    ByteSink plain(gzip, "null");
    write_snapshot(plain, shapes.filtration, shapes.points, {}, facts);
    gzip.finish();
    packed.flush();
    text.finish();
  });
  const std::string page = written([&](ByteSink& sink) {
    write_page(sink, "<title>%ORTHOBALL_TITLE%</title><data>%ORTHOBALL_SNAPSHOT%</data>",
               shapes.filtration, shapes.points, {}, facts);
  });
  EXPECT_EQ(page, "<title>a&lt;b&amp;c.csv</title><data>" + snapshot + "</data>");
}

}  // namespace
}  // namespace orthoball
