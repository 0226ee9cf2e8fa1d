// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/elements.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/molecule.h"
#include "orthoball/input/plain_row.h"

// XYZ: frames of a line with the number of atoms, a comment, and a line `element x y z` for each
// atom. In the extended form the comment holds key=value pairs, and Properties names the columns,
// of which species or Z, pos and radius are read.
// Frames that are not taken are checked for their number of lines, so that a wrong count is found
// wherever it is.

namespace orthoball {
namespace {

constexpr std::size_t kMostColumns = 1000;  // of one property
constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

// Which words of an atom's line mean what.
struct AtomColumns {
  std::size_t element = 0;
  std::size_t x = 1;  // y and z follow
  std::size_t radius = kNoColumn;
  std::size_t least = 4;
  bool is_exact = false;     // no more columns than `least`
  bool has_numbers = false;  // atomic numbers instead of symbols
};

bool is_whole_number(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

char closing(char opening) {
  switch (opening) {
    case '"':
    case '\'':
      return opening;
    case '{':
      return '}';
    case '[':
      return ']';
    default:
      return '\0';
  }
}

// Where the value that begins at `begin` of an extended comment ends: behind its closing quote or
// bracket if it has one.
std::size_t end_of_value(const Source& source, std::size_t line, std::string_view comment,
                         std::size_t begin) {
  const char close = begin < comment.size() ? closing(comment[begin]) : '\0';
  for (std::size_t i = begin + (close == '\0' ? 0 : 1); i < comment.size(); ++i) {
    if (comment[i] == '\\') {
      ++i;
    } else if (close == '\0' ? is_blank(comment[i]) : comment[i] == close) {
      return close == '\0' ? i : i + 1;
    }
  }
  if (close == '\0') return comment.size();
  throw ParseError(source.name, line,
                   "the value " + quoted(comment.substr(begin)) + " is not closed; " + close +
                       " is needed at its end");
}

// The value of `key` in an extended comment, without its quotes.
std::optional<std::string_view> value_of(const Source& source, std::size_t line,
                                         std::string_view comment, std::string_view key) {
  std::size_t at = 0;
  while (at < comment.size()) {
    if (is_blank(comment[at])) {
      ++at;
      continue;
    }
    const std::size_t end_of_key = std::min(comment.find_first_of("= \t", at), comment.size());
    const std::string_view found = comment.substr(at, end_of_key - at);
    at = end_of_key;
    if (at == comment.size() || comment[at] != '=') continue;
    const std::size_t end = end_of_value(source, line, comment, at + 1);
    std::string_view value = comment.substr(at + 1, end - at - 1);
    if (!value.empty() && closing(value.front()) != '\0') value = value.substr(1, value.size() - 2);
    if (found == key) return value;
    at = end;
  }
  return std::nullopt;
}

// Reads the columns from "species:S:1:pos:R:3:...".
AtomColumns columns_of(const Source& source, std::size_t line, std::string_view properties) {
  const auto fail = [&](const std::string& message) {
    throw ParseError(source.name, line, message + "; Properties=species:S:1:pos:R:3 is the usual");
  };
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= properties.size();) {
    const std::size_t end = std::min(properties.find(':', begin), properties.size());
    parts.push_back(properties.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() % 3 != 0) fail("Properties is " + quoted(properties) + ", not name:type:count");
  AtomColumns columns{.element = kNoColumn, .x = kNoColumn, .least = 0, .is_exact = true};
  for (std::size_t i = 0; i < parts.size(); i += 3) {
    const std::size_t count = count_at(source, line, parts[i + 2], "a count in Properties");
    if (count == 0 || count > kMostColumns) fail("Properties has a count out of range");
    if (parts[i] == "pos") {
      if (count != 3) fail("pos has " + counted(count, "column") + ", 3 are needed");
      columns.x = columns.least;
    } else if (parts[i] == "radius") {
      if (count != 1) fail("radius has " + counted(count, "column") + ", 1 is needed");
      columns.radius = columns.least;
    } else if (parts[i] == "species" || (parts[i] == "Z" && columns.element == kNoColumn)) {
      columns.element = columns.least;
      columns.has_numbers = parts[i] == "Z";
    }
    columns.least += count;
  }
  if (columns.x == kNoColumn) fail("Properties names no pos");
  return columns;
}

AtomColumns columns_of_comment(const Source& source, std::size_t line, std::string_view comment,
                               std::vector<std::string>& warnings) {
  if (comment.find("Properties=") == std::string_view::npos &&
      comment.find("Lattice=") == std::string_view::npos) {
    return {};
  }
  if (const auto lattice = value_of(source, line, comment, "Lattice")) {
    std::vector<std::string_view> numbers;
    split_at_blanks(*lattice, numbers);
    if (numbers.size() != 9) {
      warnings.push_back("line " + std::to_string(line) + ": Lattice has " +
                         counted(numbers.size(), "number") + " instead of 9; the cell is not used");
    }
  }
  const auto properties = value_of(source, line, comment, "Properties");
  return properties ? columns_of(source, line, *properties) : AtomColumns{};
}

std::string_view element_of(std::string_view word, bool has_numbers) {
  if (has_numbers || is_whole_number(word)) {
    int number = 0;
    std::from_chars(word.data(), word.data() + word.size(), number);
    const std::string_view symbol = element_symbol(number);
    return symbol.empty() ? word : symbol;
  }
  const std::string_view symbol = element_symbol(word);
  if (!symbol.empty()) return symbol;
  // "C12", "Fe3+": the symbol is all of the letters, or the word names no element.
  const auto end = std::find_if(word.begin(), word.end(), [](char c) {
    return !((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'));
  });
  const std::string_view letters =
      element_symbol(word.substr(0, static_cast<std::size_t>(end - word.begin())));
  return letters.empty() ? word : letters;
}

Atom atom_of(const Source& source, std::size_t line, const std::vector<std::string_view>& words,
             const AtomColumns& columns) {
  if (words.size() < columns.least || (columns.is_exact && words.size() != columns.least)) {
    throw ParseError(source.name, line,
                     "the line has " + counted(words.size(), "column") + "; " +
                         (columns.is_exact ? std::to_string(columns.least) + " as Properties says"
                                           : "element x y z") +
                         " are needed");
  }
  Atom atom;
  atom.position = {number_at(source, line, words[columns.x], "x"),
                   number_at(source, line, words[columns.x + 1], "y"),
                   number_at(source, line, words[columns.x + 2], "z")};
  if (columns.radius != kNoColumn) {
    atom.radius = number_at(source, line, words[columns.radius], "the radius");
  }
  if (columns.element != kNoColumn) {
    atom.element = element_of(words[columns.element], columns.has_numbers);
  }
  atom.line = line;
  return atom;
}

// Reads one frame behind its count; keeps its atoms if it is taken. Radii are read if none are
// named by the options.
void read_frame(const Source& source, Lines& lines, std::size_t count, bool is_taken,
                const ReadOptions& options, Molecule& molecule) {
  const std::size_t head = lines.number();
  std::string_view line;
  if (!lines.next(line)) line = {};
  AtomColumns columns;
  if (is_taken) columns = columns_of_comment(source, lines.number(), line, molecule.warnings);
  if (!options.radii.empty()) columns.radius = kNoColumn;
  molecule.has_radii = molecule.has_radii || columns.radius != kNoColumn;
  std::vector<std::string_view> words;
  // No more than the bytes that follow can hold.
  if (is_taken) molecule.atoms.reserve(std::min(count, lines.rest().size() / 8 + 1));
  for (std::size_t i = 0; i < count; ++i) {
    if (!lines.next(line) || trimmed(line).empty()) {
      throw ParseError(source.name, head,
                       "the count is " + std::to_string(count) + ", but " + counted(i, "atom") +
                           (i == 1 ? " follows" : " follow") + "; the number of atoms is needed");
    }
    if (!is_taken) continue;
    split_at_blanks(line, words);
    molecule.atoms.push_back(atom_of(source, lines.number(), words, columns));
  }
}

// --- files of one plain frame --------------------------------------------------------------------

// What a word at the begin of a line stands for.
struct Kind {
  std::string_view element;
  ShortDecimal radius;
};

// The kinds of atoms of a frame, each looked up once.
class Kinds {
 public:
  explicit Kinds(RadiusAssignment* radii) : radii_(radii) {}

  // Null for an element without a radius.
  const Kind* of(std::string_view word, bool has_numbers) {
    if (last_ != nullptr && word == last_word_) return last_;
    const auto known = kinds_.find(word);
    last_ = known != kinds_.end() ? &known->second : add(word, has_numbers);
    last_word_ = word;
    return last_;
  }

 private:
  const Kind* add(std::string_view word, bool has_numbers) {
    Kind kind{element_of(word, has_numbers), {}};
    if (radii_ != nullptr) {
      Atom atom;
      atom.element = kind.element;
      const auto radius = radii_->radius(atom);
      if (!radius || radius->digits > kMostDigits || radius->digits < -kMostDigits) return nullptr;
      kind.radius = {static_cast<std::int64_t>(radius->digits), -radius->exponent};
    }
    return &kinds_.emplace(word, kind).first->second;
  }

  static constexpr Int128 kMostDigits = 1'000'000'000'000'000;
  RadiusAssignment* radii_;
  std::map<std::string_view, Kind> kinds_;
  std::string_view last_word_;
  const Kind* last_ = nullptr;
};

// A file that is one frame of plain lines `element x y z ...`, read in one pass over its bytes
// without an Atom for each line. Empty where anything is different or wrong: then the general way
// begins anew, and says what is wrong.
std::optional<Reading> plain_reading(const Source& source, const ReadOptions& options) {
  if (!(options.molecule == MoleculeOptions{}) || options.default_radius ||
      options.radii == "protor") {
    return std::nullopt;
  }
  Lines lines(source.bytes);
  std::string_view line;
  std::size_t count = 0;
  if (!lines.next(line)) return std::nullopt;
  const std::string_view head = trimmed(line);
  const auto [end_of_count, error] = std::from_chars(head.data(), head.data() + head.size(), count);
  if (error != std::errc() || end_of_count != head.data() + head.size() || count == 0 ||
      count > source.bytes.size() / 7 || !lines.next(line)) {
    return std::nullopt;
  }
  std::vector<std::string> warnings;
  const AtomColumns columns = columns_of_comment(source, lines.number(), line, warnings);
  if (columns.element != 0 || columns.x != 1) return std::nullopt;
  if (columns.radius != kNoColumn && options.radii.empty()) return std::nullopt;

  const char* at = lines.rest().data();
  const char* const end = at + lines.rest().size();
  std::vector<std::string_view> words;
  split_at_blanks({at, std::min(lines.rest().find('\n'), lines.rest().size())}, words);
  if (words.size() < columns.least || words.size() > kMostColumns) return std::nullopt;
  if (columns.is_exact && words.size() != columns.least) return std::nullopt;
  std::vector<std::uint8_t> slots(words.size(), kUnusedColumn);
  for (std::uint8_t axis = 0; axis < 3; ++axis) slots[1 + std::size_t{axis}] = axis;

  const bool is_weighted = options.radii != "none";
  std::optional<RadiusAssignment> radii;
  if (is_weighted) radii.emplace(options);
  Kinds kinds(is_weighted ? &*radii : nullptr);
  DecimalRows rows(3, is_weighted ? WeightKind::radius : WeightKind::none);
  Reading reading{.points = WeightedPoints(3), .warnings = std::move(warnings)};
  rows.reserve(count);
  reading.labels.line.reserve(count);
  reading.labels.element.reserve(count);
  const std::size_t first_line = lines.number() + 1;
  std::array<ShortDecimal, 4> numbers;
  const std::size_t width = is_weighted ? 4 : 3;
  for (std::size_t i = 0; i < count; ++i) {
    const char* const row = at;
    at = read_plain_row(at, end, {}, slots, numbers.data(), parse_short_decimal);
    if (at == nullptr) return std::nullopt;
    const char* const word = std::find_if_not(row, at, is_blank);
    const char* const end_of_word = std::find_if(word, at, is_blank);
    const Kind* const kind =
        kinds.of({word, static_cast<std::size_t>(end_of_word - word)}, columns.has_numbers);
    if (kind == nullptr) return std::nullopt;
    numbers[3] = kind->radius;
    if (!rows.add_short(std::span(numbers).first(width))) {
      std::array<DecimalNumber, 4> exact;
      for (std::size_t n = 0; n < width; ++n) {
        exact[n] = decimal_number(numbers[n].digits, -numbers[n].decimals);
      }
      rows.add(std::span(exact).first(3), exact[3]);
    }
    reading.labels.line.push_back(static_cast<std::uint32_t>(
        std::min<std::size_t>(first_line + i, std::numeric_limits<std::uint32_t>::max())));
    reading.labels.element.emplace_back(kind->element);
  }
  if (std::string_view(at, static_cast<std::size_t>(end - at)).find_first_not_of(" \t\r\n") !=
      std::string_view::npos) {
    return std::nullopt;
  }
  reading.points = std::move(rows).points();
  reading.file = source.name;
  reading.radii = is_weighted ? radii->description() : "none";
  reading.is_molecule = is_weighted;
  return reading;
}

}  // namespace

Reading read_xyz(const Source& source, const ReadOptions& options) {
  require_molecule_options(options, "xyz");
  require_text(source);
  if (auto reading = plain_reading(source, options)) return std::move(*reading);
  Molecule molecule;
  ModelChoice frames(options.molecule.model, "frame");
  Lines lines(source.bytes);
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view text = trimmed(line);
    if (text.empty()) continue;
    const std::size_t count =
        count_at(source, lines.number(), text, "the number of atoms of a frame");
    const bool is_taken = frames.takes(frames.next_number());
    read_frame(source, lines, count, is_taken, options, molecule);
  }
  frames.finish(source, molecule.notes);
  return reading_of(source, std::move(molecule), options);
}

}  // namespace orthoball
