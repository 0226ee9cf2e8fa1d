// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <gemmi/cif.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/atom_site.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/molecule.h"

// mmCIF and core CIF. The grammar is gemmi's, the actions are ours: they hand views into the text
// to an AtomSiteReader, each with its line. The grammar has no recursion and no lookahead beyond a
// token, so time is linear and the stack is flat whatever the bytes are.

namespace orthoball {
namespace {

namespace pegtl = tao::pegtl;
namespace rules = gemmi::cif::rules;

struct Events {
  const Source& source;
  AtomSiteReader& reader;
  const char* token_end;      // of the last value or tag
  std::string_view tag = {};  // of the item at hand
  std::size_t tag_line = 0;
};

template <class Input>
CifValue value_of(const Input& in) {
  CifValue value{in.string_view(), in.string_view(), in.iterator().line};
  const char first = value.text.front();
  if (first == '\'' || first == '"') {
    value.text = value.text.substr(1, value.text.size() - 2);
  } else if (first == ';' && in.iterator().column == 1) {
    value.text = value.text.substr(1, value.text.size() - 2);
    while (!value.text.empty() && (value.text.back() == '\n' || value.text.back() == '\r')) {
      value.text.remove_suffix(1);
    }
  } else if (value.text == "." || value.text == "?") {
    value.text = {};
  }
  return value;
}

template <class Rule>
struct Action : pegtl::nothing<Rule> {};

template <>
struct Action<rules::datablockname> {
  template <class Input>
  static void apply(const Input& in, Events& events) {
    events.reader.begin_block(in.string_view());
  }
};
template <>
struct Action<rules::str_global> {
  template <class Input>
  static void apply(const Input& in, Events& events) {
    events.reader.begin_block(in.string_view());
  }
};
template <>
struct Action<rules::str_loop> {
  static void apply0(Events& events) { events.reader.begin_loop(); }
};
template <>
struct Action<rules::loop_tag> {
  template <class Input>
  static void apply(const Input& in, Events& events) {
    events.reader.loop_tag(in.string_view());
    events.token_end = in.end();
  }
};
template <>
struct Action<rules::loop_value> {
  template <class Input>
  static void apply(const Input& in, Events& events) {
    events.reader.loop_value(value_of(in));
    events.token_end = in.end();
  }
};
template <>
struct Action<rules::loop> {
  static void apply0(Events& events) { events.reader.end_loop(); }
};
template <>
struct Action<rules::item_tag> {
  template <class Input>
  static void apply(const Input& in, Events& events) {
    events.tag = in.string_view();
    events.tag_line = in.iterator().line;
    events.token_end = in.end();
  }
};
template <>
struct Action<rules::item_value> {
  template <class Input>
  static void apply(const Input& in, Events& events) {
    events.reader.item(events.tag, value_of(in));
    events.token_end = in.end();
  }
};
template <>
struct Action<rules::missing_value> {
  static void apply0(Events& events) {
    throw ParseError(events.source.name, events.tag_line,
                     quoted(events.tag) + " has no value; ? stands for an unknown one");
  }
};

// gemmi's messages say what is wrong; this adds what would be right.
[[noreturn]] void fail(const Source& source, std::string_view text, const pegtl::parse_error& error,
                       const char* token_end) {
  std::string message(error.message());
  std::size_t line = error.positions().front().line;
  if (message == "unterminated text field") {
    // The grammar stops at the end of the file; the field began at the next ; in the first column.
    const auto parsed = static_cast<std::size_t>(token_end - text.data());
    const std::size_t begin = std::min(text.find("\n;", parsed), text.size() - 1);
    line = 2 + static_cast<std::size_t>(std::count(
                   text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    message = "the text field is never closed; a ; in the first column is needed";
  } else if (message.compare(0, 12, "unterminated") == 0) {
    message += "; the same quote is needed before the line ends";
  } else if (message == "parse error") {
    message = "this is not CIF; data_NAME, loop_, _tag value are what it is made of";
  }
  throw ParseError(source.name, line, message);
}

Molecule molecule_of(const Source& source, std::string_view text, const ReadOptions& options) {
  AtomSiteReader reader(source, options);
  Events events{source, reader, text.data()};
  pegtl::memory_input<> input(text.data(), text.size(), source.name);
  try {
    pegtl::parse<rules::file, Action, gemmi::cif::Errors>(input, events);
  } catch (const pegtl::parse_error& error) {
    fail(source, text, error, events.token_end);
  }
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
