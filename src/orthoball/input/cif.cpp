// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>

#include "orthoball/input/atom_site.h"
#include "orthoball/input/cif_tokens.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/molecule.h"

namespace orthoball {
namespace {

Molecule molecule_of(const Source& source, std::string_view text, const ReadOptions& options) {
  AtomSiteReader reader(source, options);
  std::string_view tag;
  read_cif_tokens(source, text, [&](const CifToken& token) {
    const CifValue value{token.text, token.written, token.line};
    switch (token.kind) {
      case CifToken::Kind::block:
        return reader.begin_block(token.text);
      case CifToken::Kind::loop:
        return reader.begin_loop();
      case CifToken::Kind::loop_tag:
        return reader.loop_tag(token.text);
      case CifToken::Kind::loop_value:
        return reader.loop_value(value);
      case CifToken::Kind::loop_end:
        return reader.end_loop();
      case CifToken::Kind::item_tag:
        tag = token.text;
        return;
      case CifToken::Kind::item_value:
        return reader.item(tag, value);
    }
  });
  return reader.finish();
}

}  // namespace

Reading read_cif(const Source& source, const ReadOptions& options) {
  require_molecule_options(options, "cif");
  require_text(source);
  // The grammar ends lines at \n; old ones with \r alone get it here.
  if (source.bytes.find('\n') != std::string::npos ||
      source.bytes.find('\r') == std::string::npos) {
    return reading_of(source, molecule_of(source, source.bytes, options), options);
  }
  std::string text = source.bytes;
  std::replace(text.begin(), text.end(), '\r', '\n');
  return reading_of(source, molecule_of(source, text, options), options);
}

}  // namespace orthoball
