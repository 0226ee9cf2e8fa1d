// SPDX-License-Identifier: MIT
#include "orthoball/output/plot_text.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

TEST(PlotText, EscapesNamesForXml) {
  EXPECT_EQ(xml_text("a<b>&\"c\"\n"), "a&lt;b&gt;&amp;&quot;c&quot; ");
  EXPECT_EQ(xml_text("\u00e5\u4e2d\U0001f600"), "\u00e5\u4e2d\U0001f600");
}

TEST(PlotText, ReplacesBytesThatAreNotUtf8) {
  for (const char* const bad : {"\xff", "\x80", "\xc3", "\xc1\xa0", "\xed\xa0\x80", "\xef\xbf\xbe",
                                "\xf5\x80\x80\x80", "\xf0\x80\x80\x80", "\xe2\x82"}) {
    std::string expected = "a";
    for (std::size_t i = 0; bad[i] != '\0'; ++i) expected += "\uFFFD";
    EXPECT_EQ(xml_text(std::string("a") + bad + "b"), expected + "b");
  }
}

TEST(PlotText, WidthGrowsWithCharactersAndNotWithBytes) {
  EXPECT_LT(text_width("iii", 10), text_width("mmm", 10));
  EXPECT_EQ(text_width("\u00e5", 10), text_width("a", 10));
  EXPECT_EQ(text_width("abc", 20), 2 * text_width("abc", 10));
}

TEST(PlotText, ShortensWhatDoesNotFit) {
  EXPECT_EQ(shortened("short", 100, 10), "short");
  const std::string text = shortened(std::string(150, 'x') + "y", 100, 10);
  EXPECT_LE(text_width(text, 10), 100);
  EXPECT_GT(text_width(text, 10), 80);
  EXPECT_TRUE(text.ends_with("x\u2026"));
  EXPECT_EQ(shortened("\u4e2d\u4e2d\u4e2d\u4e2d", 25, 10), "\u4e2d\u2026");
}

}  // namespace
}  // namespace orthoball
