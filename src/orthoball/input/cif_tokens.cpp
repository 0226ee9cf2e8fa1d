// SPDX-License-Identifier: MIT
#include "orthoball/input/cif_tokens.h"

#include <algorithm>
#include <gemmi/cif.hpp>
#include <string>

#include "orthoball/error.h"

// The grammar is gemmi's, the actions are ours: nothing of the file is stored. This file is C++17,
// because gemmi 0.5.7 is not C++20 for clang, and so are the headers it includes.

namespace orthoball {
namespace {

namespace pegtl = tao::pegtl;
namespace rules = gemmi::cif::rules;

struct Tokens {
  const Source& source;
  const std::function<void(const CifToken&)>& take;
  const char* token_end;      // of the last value or tag
  std::string_view tag = {};  // of the item at hand
  std::size_t tag_line = 0;
};

template <class Input>
std::string_view view(const Input& in) {
  return {in.begin(), in.size()};
}

template <class Input>
void take_name(const Input& in, Tokens& tokens, CifToken::Kind kind) {
  tokens.take({kind, view(in), view(in), in.iterator().line});
  tokens.token_end = in.end();
}

template <class Input>
void take_value(const Input& in, Tokens& tokens, CifToken::Kind kind) {
  CifToken token{kind, view(in), view(in), in.iterator().line};
  const char first = token.text.front();
  if (first == '\'' || first == '"') {
    token.text = token.text.substr(1, token.text.size() - 2);
  } else if (first == ';' && in.iterator().column == 1) {
    token.text = token.text.substr(1, token.text.size() - 2);
    while (!token.text.empty() && (token.text.back() == '\n' || token.text.back() == '\r')) {
      token.text.remove_suffix(1);
    }
  } else if (token.text == "." || token.text == "?") {
    token.text = {};
  }
  tokens.take(token);
  tokens.token_end = in.end();
}

template <class Rule>
struct Action : pegtl::nothing<Rule> {};

template <>
struct Action<rules::datablockname> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    take_name(in, tokens, CifToken::Kind::block);
  }
};
template <>
struct Action<rules::str_global> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    take_name(in, tokens, CifToken::Kind::block);
  }
};
template <>
struct Action<rules::str_loop> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    take_name(in, tokens, CifToken::Kind::loop);
  }
};
template <>
struct Action<rules::loop_tag> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    take_name(in, tokens, CifToken::Kind::loop_tag);
  }
};
template <>
struct Action<rules::loop_value> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    take_value(in, tokens, CifToken::Kind::loop_value);
  }
};
template <>
struct Action<rules::loop> {
  static void apply0(Tokens& tokens) { tokens.take({CifToken::Kind::loop_end, {}, {}, 0}); }
};
template <>
struct Action<rules::item_tag> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    tokens.tag = view(in);
    tokens.tag_line = in.iterator().line;
    take_name(in, tokens, CifToken::Kind::item_tag);
  }
};
template <>
struct Action<rules::item_value> {
  template <class Input>
  static void apply(const Input& in, Tokens& tokens) {
    take_value(in, tokens, CifToken::Kind::item_value);
  }
};
template <>
struct Action<rules::missing_value> {
  static void apply0(Tokens& tokens) {
    throw ParseError(tokens.source.name, tokens.tag_line,
                     quoted(tokens.tag) + " has no value; ? stands for an unknown one");
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

}  // namespace

void read_cif_tokens(const Source& source, std::string_view text,
                     const std::function<void(const CifToken&)>& take) {
  Tokens tokens{source, take, text.data()};
  pegtl::memory_input<> input(text.data(), text.size(), source.name);
  try {
    pegtl::parse<rules::file, Action, gemmi::cif::Errors>(input, tokens);
  } catch (const pegtl::parse_error& error) {
    fail(source, text, error, tokens.token_end);
  }
}

}  // namespace orthoball
